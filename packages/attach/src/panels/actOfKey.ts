import { isComposing, isTyping, latinKey } from '@farol/editing';
import { duplicateSelected } from '../model/duplicateSelected';
import { removeSelected } from '../model/removeSelected';
import type { Session } from '../model/Session';
import type { Gizmo } from '../viewport/Gizmo';
import { gizmoKey } from './Bar';

/** Action of a key while the focus is in the panels; null for none, as while a text field is edited. */
export function actOfKey(session: Session, gizmo: Gizmo, event: KeyboardEvent): (() => unknown) | null {
  if (event.altKey || isComposing(event)) return null;
  const key = latinKey(event).toLowerCase();
  if (!event.ctrlKey && !event.metaKey) {
    if (isTyping(event)) return null;
    return key === 'delete' ? () => removeSelected(session) : gizmoKey(gizmo, key);
  }
  if (key === 'd') return () => duplicateSelected(session);
  if (key === 'y' || (key === 'z' && event.shiftKey)) return () => session.commands.redo();
  return key === 'z' ? () => session.commands.undo() : null;
}
