import type { FieldValue } from '../fields/Field';
import type { FieldTarget } from '../fields/FieldTarget';
import type { Command } from './Command';
import type { EditRecorder } from './EditRecorder';
import { Gesture } from './Gesture';
import { Signal } from '../Signal';

/** Undo history of a document. */
export class CommandStack<Item = string> {
  /** Emits when the history changes. */
  readonly changed = new Signal();
  /** Replaces each command that is run or previewed, for instance while an animation is recorded; null for none. */
  recorder: EditRecorder<Item> | null = null;

  private readonly done: Command<Item>[] = [];
  private readonly undone: Command<Item>[] = [];
  private gesture: Gesture<Item> | null = null;
  /** Last command at the saved state, null at the start; undefined when undo and redo cannot reach that state. */
  private savedAt: Command<Item> | null | undefined = null;
  /** Number of oldest steps that `undo` cannot reach, see `hold`. */
  private held = 0;
  private isHeld = false;

  /**
   * @param onApplied - called after a command was done or undone
   * @param limit - greatest number of steps; older ones are dropped
   */
  constructor(
    private readonly onApplied: (command: Command<Item>, isDone: boolean) => void = () => {},
    private readonly limit = 1000,
  ) {}

  /** The command that `undo` would undo; null for none. */
  get last(): Command<Item> | null {
    return this.done.at(-1) ?? null;
  }

  /** Label of the step that `undo` would undo; null for none. */
  get undoLabel(): string | null {
    return this.done.length > this.held ? this.done.at(-1)!.label : null;
  }

  /** Label of the step that `redo` would redo; null for none. */
  get redoLabel(): string | null {
    return this.undone.at(-1)?.label ?? null;
  }

  /** Labels of all steps that can be undone, oldest first. */
  get history(): readonly string[] {
    return this.done.map(({ label }) => label);
  }

  /** Labels of all steps that can be redone, the next one first. */
  get future(): readonly string[] {
    return this.undone.map(({ label }) => label).toReversed();
  }

  /** Whether the document differs from its saved state. */
  get isDirty(): boolean {
    return (this.done.at(-1) ?? null) !== this.savedAt;
  }

  /** Whether a gesture (an edit of many previews) is under way. */
  get isGestureOpen(): boolean {
    return this.gesture !== null;
  }

  /** Value from which an edit of a field starts: the authored one, unless the recorder supplies another. */
  valueOf(owner: FieldTarget, name: string): FieldValue {
    return this.recorder?.valueOf(owner, name) ?? owner.getAuthored(name);
  }

  /** Runs a command as one step. An open gesture is committed first. @throws what the command throws */
  run(asked: Command<Item>): void {
    this.gesture?.commit();
    const command = this.recorder?.begin()(asked) ?? asked;
    if (command.isEmpty) return;
    command.do();
    this.keep(command);
    this.onApplied(command, true);
    this.changed.emit();
  }

  /** Begins an edit of many previews that becomes one step of history. An open gesture is committed first. */
  begin(): Gesture<Item> {
    this.gesture?.commit();
    const gesture = new Gesture<Item>((command) => {
      this.gesture = null;
      if (command) {
        this.keep(command);
        this.onApplied(command, true);
      }
      this.changed.emit();
    }, this.recorder?.begin());
    this.gesture = gesture;
    return gesture;
  }

  /**
   * Merges `next` into the last step, for a value that arrives after its gesture was committed.
   * @param step - the command that `next` belongs to
   * @returns false, with nothing changed, when `step` is not the last step any more or cannot be merged
   */
  amend(step: Command<Item>, next: Command<Item>): boolean {
    if (this.gesture || step !== this.last || this.done.length <= this.held) return false;
    const joined = step.replaceWith?.(this.recorder?.begin()(next) ?? next);
    if (!joined) return false;
    this.done.pop();
    if (!joined.isEmpty) this.keep(joined);
    this.onApplied(joined, true);
    this.changed.emit();
    return true;
  }

  /** Undoes the last step; an open gesture is committed first. @returns whether there was one */
  undo(): boolean {
    this.gesture?.commit();
    const command = this.done.length > this.held ? this.done.at(-1) : undefined;
    if (!command) return false;
    this.recorder?.interrupt();
    command.undo();
    this.done.pop();
    this.undone.push(command);
    this.onApplied(command, false);
    this.changed.emit();
    return true;
  }

  /** Redoes the last undone step. @returns whether there was one */
  redo(): boolean {
    this.gesture?.commit();
    const command = this.undone.at(-1);
    if (!command) return false;
    this.recorder?.interrupt();
    command.do();
    this.undone.pop();
    this.done.push(command);
    this.onApplied(command, true);
    this.changed.emit();
    return true;
  }

  /** Begins a group of steps that `release` can undo at once; earlier steps cannot be undone until then. */
  hold(): void {
    this.gesture?.commit();
    this.held = this.done.length;
    this.isHeld = true;
    this.changed.emit();
  }

  /**
   * Undoes all steps since `hold`, and removes them from the history.
   * @param failed - called for a step that cannot be undone, such as an edit of a removed object; the other steps are
   *   undone. When absent, the error is thrown
   * @returns the undone steps, oldest first: the caller must redo or `forget` them
   */
  release(failed?: (command: Command<Item>, error: unknown) => void): Command<Item>[] {
    if (!this.isHeld) return [];
    this.gesture?.commit();
    const taken = this.done.splice(this.held).toReversed();
    for (const command of taken) {
      try {
        command.undo();
        this.onApplied(command, false);
      } catch (error) {
        if (!failed) throw error;
        failed(command, error);
      }
    }
    // steps that can be redone follow on the removed ones, so they are lost too
    if (taken.length > 0) for (const command of this.undone.splice(0)) command.forget?.(false);
    this.held = 0;
    this.isHeld = false;
    this.changed.emit();
    return taken.toReversed();
  }

  /** Marks the state after a step as saved: after the last step, unless another is given. */
  markSaved(step?: Command<Item> | null): void {
    this.gesture?.commit();
    this.savedAt = step === undefined ? this.last : step;
    this.changed.emit();
  }

  /** Marks the document as unsaved in every state that undo and redo can reach. */
  markUnsaved(): void {
    this.savedAt = undefined;
    this.changed.emit();
  }

  /** Clears the history, for another document; an open gesture is discarded. */
  clear(): void {
    this.gesture?.discard();
    for (const command of this.done.splice(0)) command.forget?.(true);
    for (const command of this.undone.splice(0)) command.forget?.(false);
    this.savedAt = null;
    this.held = 0;
    this.isHeld = false;
    this.changed.emit();
  }

  private keep(command: Command<Item>): void {
    for (const each of this.undone.splice(0)) each.forget?.(false);
    this.done.push(command);
    if (this.done.length > this.limit && !this.isHeld) this.done.shift()?.forget?.(true);
  }
}
