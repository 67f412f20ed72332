import { t } from '@farol/editing';
import { type ReactNode, useSyncExternalStore } from 'react';
import { useEditor, useSignal } from '../../ui/EditorContext';
import { isTouchScreen } from '../../viewport/isTouchScreen';
import type { Viewport } from '../../viewport/Viewport';

/** Notes while playing: who receives keys, and whether the camera whose view is shown can be moved. */
function textOf(viewport: Viewport): string {
  const { input, lookThrough, document } = viewport;
  if (isTouchScreen() && document.simulation.state !== 'stopped') return '';
  if (input.hasKeys) return t('Keys go to the scene. Esc gives them back.');
  if (input.wantsKeys) return t("Keys are the editor's. Press the picture to give them to the scene.");
  if (!lookThrough?.isAttached || document.simulation.state !== 'stopped') return '';
  return (
    viewport.flightProblem ??
    t('You fly {name}: drag, wheel, arrow keys, and W A S D while the right button is held.', {
      name: lookThrough.gameObject.name,
    })
  );
}

/** A line of notes over the viewport. */
export function ViewLine(): ReactNode {
  const { viewport, document } = useEditor();
  useSignal(viewport.changed);
  useSignal(document.simulation.changed);
  const text = useSyncExternalStore(viewport.drawn.subscribe, () => textOf(viewport));
  return (
    <p className="view-line" role="status" hidden={text === ''}>
      {text}
    </p>
  );
}
