import { lazy, type ReactNode, Suspense, useLayoutEffect } from 'react';
import { useEditor, useSignal } from '../ui/EditorContext';
import { usePreferences } from '../ui/usePreferences';
import { NoticeList } from './dialogs/NoticeList';
import { Dock } from './dock/Dock';
import { StatusBar } from './status/StatusBar';
import './dialogs/dialogs.css';
import './toolbar/toolbar.css';

// the toolbar is fetched late: the viewport can be shown without the library of menus and dialogs
const Toolbar = lazy(async () => ({ default: (await import('./toolbar/Toolbar')).Toolbar }));
const DialogHost = lazy(async () => ({ default: (await import('./dialogs/DialogHost')).DialogHost }));
const PlayTint = lazy(async () => ({ default: (await import('./play/PlayTint')).PlayTint }));
const Tour = lazy(async () => ({ default: (await import('./tour/Tour')).Tour }));
const PlayChanges = lazy(async () => ({ default: (await import('./play/PlayChanges')).PlayChanges }));

/** The editor's window: toolbar, panels, status bar. */
export function Layout(): ReactNode {
  const theme = usePreferences((preferences) => preferences.theme);
  useLayoutEffect(() => {
    document.documentElement.dataset.theme = theme;
  }, [theme]);
  const { document: edited, tour } = useEditor();
  const { simulation } = edited;
  const hasPlayed = useSignal(simulation.changed) > 0;
  useSignal(tour.changed);
  return (
    <div className="layout">
      <Suspense fallback={<header className="toolbar" />}>
        <Toolbar />
      </Suspense>
      <Dock>
        <PlayEditsPlace />
        <NoticeList />
      </Dock>
      <StatusBar />
      <Suspense fallback={null}>
        <DialogHost />
      </Suspense>
      <Suspense fallback={null}>{hasPlayed && <PlayTint />}</Suspense>
      <Suspense fallback={null}>{tour.current !== null && <Tour />}</Suspense>
    </div>
  );
}

/** List of edits made while playing, whose code is fetched once there are any. */
function PlayEditsPlace(): ReactNode {
  const { playEdits } = useEditor().document;
  const revision = useSignal(playEdits.changed);
  const isThere = revision > 0 && (playEdits.changes.length > 0 || playEdits.others.length > 0);
  return <Suspense fallback={null}>{isThere && <PlayChanges />}</Suspense>;
}
