import type { FieldValue } from '../fields/Field';
import type { FieldTarget } from '../fields/FieldTarget';
import type { Command } from './Command';

/** Takes edits of fields in place of the document, as an animation does that is recorded. See `CommandStack.recorder`. */
export interface EditRecorder<Item = string> {
  /** Value from which edits of a field begin; undefined for the authored one. */
  valueOf(owner: FieldTarget, name: string): FieldValue | undefined;
  /**
   * Called when an edit begins, one command or a gesture of previews.
   * @returns function from each command of the edit to the command to run in its place
   */
  begin(): (command: Command<Item>) => Command<Item>;
  /** Called before a step is undone or redone: the document must then have its authored values. */
  interrupt(): void;
}
