import type { FieldOwner, FieldValue } from '@farol/engine/fields';
import { SetFields } from './commands/SetFields';
import type { CommandStack } from './CommandStack';
import type { Gesture } from './Gesture';

/** A new value, or what becomes of each owner's value, such as another x and the same y and z. */
export type FieldUpdate = FieldValue | ((before: FieldValue) => FieldValue);

/** Edits one field of one or of several owners by hand: many previews, one step of history. */
export class FieldGesture {
  private gesture: Gesture | null = null;
  private before: readonly FieldValue[] = [];

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
    const { name } = this;
    const edits = this.owners.map((owner, i) => ({
      owner,
      name,
      value: typeof update === 'function' ? update(this.before[i]) : update,
    }));
    // a gesture that an undo has ended takes nothing more
    this.gesture.preview(new SetFields(this.label, edits));
  }

  /** Keeps what was shown last, or the value given, as one step. @throws FieldError when that is not allowed */
  commit(update?: FieldUpdate): void {
    if (update !== undefined) this.preview(update);
    this.gesture?.commit();
    this.gesture = null;
  }

  /** Goes back to what the field was. */
  discard(): void {
    this.gesture?.discard();
    this.gesture = null;
  }

  private get label(): string {
    const [owner] = this.owners;
    return `Set ${(owner.fields[this.name].label ?? this.name).toLowerCase()} of ${owner.ownerName}`;
  }
}
