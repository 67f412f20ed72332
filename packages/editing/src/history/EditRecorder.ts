import type { FieldValue } from '../fields/Field';
import type { FieldTarget } from '../fields/FieldTarget';
import type { Command } from './Command';

/** Takes edits of fields in place of the document, as an animation does that is recorded. See `CommandStack.recorder`. */
export interface EditRecorder<Item = string> {
  /** The value that edits of a field begin from; undefined for the authored one. */
  valueOf(owner: FieldTarget, name: string): FieldValue | undefined;
  /**
   * An edit begins: one command, or a gesture of many previews.
   * @returns gives for each command of the edit the one to do in its place, or the same
   */
  begin(): (command: Command<Item>) => Command<Item>;
  /** A step is about to be undone, or done again: the document must be as it was authored. */
  interrupt(): void;
}
