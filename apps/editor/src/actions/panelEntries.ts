import type { Editor } from '../Editor';
import { actionEntry, type MenuEntry } from '../ui/MenuEntry';
import { maximiseViewport, resetPanels, showPanels } from './showPanels';

/** The lines of the Panels menu. */
export function panelEntries(editor: Editor): MenuEntry[] {
  const lines = showPanels().map(
    (action) => ({ ...action, icon: action.checked?.(editor) ? 'check' : undefined }) as const,
  );
  return [
    ...lines.map((action) => actionEntry(action, editor)),
    'separator',
    ...[maximiseViewport, resetPanels].map((action) => actionEntry(action, editor)),
  ];
}
