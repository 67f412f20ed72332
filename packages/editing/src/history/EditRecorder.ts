import type { FieldValue } from '../fields/Field';
import type { FieldTarget } from '../fields/FieldTarget';
import type { Command } from './Command';

/** Redirects edits of fields away from the document, as animation recording does. See `CommandStack.recorder`. */
export interface EditRecorder<Item = string> {
  /** Value from which an edit of a field starts; undefined for the authored one. */
  valueOf(owner: FieldTarget, name: string): FieldValue | undefined;
  /**
   * Called when an edit begins, one command or a gesture of previews.
   * @returns a function that returns the command to run in place of each command of the edit
   */
  begin(): (command: Command<Item>) => Command<Item>;
  /** Called before a step is undone or redone: the document must then have its authored values. */
  interrupt(): void;
}
