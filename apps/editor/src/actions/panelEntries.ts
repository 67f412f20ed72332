import type { EditorApi } from '../api/EditorApi';
import { actionEntry, type MenuEntry } from '../api/MenuEntry';
import { maximiseViewport, resetPanels, showPanels } from './showPanels';

/** The lines of the Panels menu. */
export function panelEntries(editor: EditorApi): MenuEntry[] {
  const lines = showPanels(editor).map(
    (action) => ({ ...action, icon: action.checked?.(editor) ? 'check' : undefined }) as const,
  );
  return [
    ...lines.map((action) => actionEntry(action, editor)),
    'separator',
    ...[maximiseViewport, resetPanels].map((action) => actionEntry(action, editor)),
  ];
}
