import { type ReactNode, useLayoutEffect } from 'react';
import { usePreferences } from '../ui/preferences';
import { DialogHost } from './dialogs/DialogHost';
import { NoticeList } from './dialogs/NoticeList';
import { Dock } from './dock/Dock';
import { StatusBar } from './status/StatusBar';
import { Toolbar } from './toolbar/Toolbar';

/** The editor's window: bar, panels, status. */
export function Layout(): ReactNode {
  const theme = usePreferences((preferences) => preferences.theme);
  useLayoutEffect(() => {
    document.documentElement.dataset.theme = theme;
  }, [theme]);
  return (
    <div className="layout">
      <Toolbar />
      <Dock>
        <NoticeList />
      </Dock>
      <StatusBar />
      <DialogHost />
    </div>
  );
}
