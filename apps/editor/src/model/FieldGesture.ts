import type { FieldOwner, FieldValue } from '@farol/engine/fields';
import type { Command } from './Command';
import { SetFields } from './commands/SetFields';
import type { CommandStack } from './CommandStack';
import type { Gesture } from './Gesture';

/** A new value, or what becomes of each owner's value, such as another x and the same y and z. */
export type FieldUpdate = FieldValue | ((before: FieldValue) => FieldValue);

/** Edits one field of one or of several owners by hand: many previews, one step of history. */
export class FieldGesture {
  private gesture: Gesture | null = null;
  private before: readonly FieldValue[] = [];
  /** The step that the last commit made; null when it made none. */
  private step: Command | null = null;

  /** @param owners - all of one type */
  constructor(
    private readonly commands: CommandStack,
    private readonly owners: readonly FieldOwner[],
    private readonly name: string,
  ) {}

  /** Shows what the field would be. @throws FieldError when it is not allowed */
  preview(update: FieldUpdate): void {
    if (!this.gesture) {
      this.before = this.owners.map((owner) => owner.getAuthored(this.name));
      this.gesture = this.commands.begin();
    }
    // a gesture that an undo has ended takes nothing more
    this.gesture.preview(this.setTo(update));
  }

  /** Keeps what was shown last, or the value given, as one step. @throws FieldError when that is not allowed */
  commit(update?: FieldUpdate): void {
    if (update !== undefined) this.preview(update);
    const { last } = this.commands;
    this.gesture?.commit();
    this.gesture = null;
    this.step = this.commands.last === last ? null : this.commands.last;
  }

  /**
   * A value of the edit that was committed last, which comes late: part of the same step. An undo of the step, and a step
   * after it, let such a value pass.
   * @throws FieldError when it is not allowed
   */
  amend(update: FieldUpdate): void {
    if (!this.step) this.commit(update);
    else if (this.commands.amend(this.step, this.setTo(update))) this.step = this.commands.last;
  }

  /** Goes back to what the field was. */
  discard(): void {
    this.gesture?.discard();
    this.gesture = null;
  }

  private setTo(update: FieldUpdate): SetFields {
    const { name } = this;
    const edits = this.owners.map((owner, i) => ({
      owner,
      name,
      value: typeof update === 'function' ? update(this.before[i]) : update,
    }));
    return new SetFields(this.label, edits);
  }

  private get label(): string {
    const [owner] = this.owners;
    return `Set ${(owner.fields[this.name].label ?? this.name).toLowerCase()} of ${owner.ownerName}`;
  }
}
