import type { Command } from '../history/Command';
import type { CommandStack } from '../history/CommandStack';
import type { Gesture } from '../history/Gesture';
import { currentOf } from './currentOf';
import { labelOfField } from './labelOfField';
import type { FieldValue } from './Field';
import type { FieldDescription, FieldTarget } from './FieldTarget';
import { sameValue } from './sameValue';
import { type FieldEdit, SetFields } from './SetFields';
import { valueText } from './valueText';
import { t } from '../language/translate';

/** A new value, or a function of each owner's own value, for instance to change x and keep y and z. */
export type FieldUpdate<Value extends FieldValue = FieldValue> = Value | ((before: Value, owner: FieldTarget) => Value);

/** Edits one field of one or several owners interactively: many previews, one step of history. */
export class FieldGesture<Item = string> {
  private gesture: Gesture<Item> | null = null;
  private previousValues: readonly FieldValue[] = [];
  /** Step of history made by the last commit; null when the commit changed nothing. */
  private step: Command<Item> | null = null;

  /**
   * @param owners - at least one
   * @param name - name of the field, or a function of the owner when owners are of several types
   * @param whose - name of the owners in labels of the history; `ownerName` when absent
   */
  constructor(
    private readonly commands: CommandStack<Item>,
    private readonly owners: readonly FieldTarget[],
    private readonly name: string | ((owner: FieldTarget) => string),
    private readonly whose?: () => string,
  ) {}

  /** Whether an edit is under way: previewed, and neither committed, discarded nor ended by an undo. */
  get isOpen(): boolean {
    return this.gesture?.isOpen ?? false;
  }

  /** Previews a new value. */
  preview<Value extends FieldValue>(update: FieldUpdate<Value>): void {
    if (!this.gesture) {
      this.previousValues = this.owners.map((owner) => this.commands.valueOf(currentOf(owner), this.nameOf(owner)));
      this.gesture = this.commands.begin();
    }
    // does nothing once an undo has ended the gesture
    this.gesture.preview(this.setTo(update));
  }

  /** Commits the last preview, or the given value, as one step. @throws Error when the value is not allowed */
  commit<Value extends FieldValue>(update?: FieldUpdate<Value>): void {
    if (update !== undefined) this.preview(update);
    const { last } = this.commands;
    this.gesture?.commit();
    this.gesture = null;
    this.step = this.commands.last === last ? null : this.commands.last;
  }

  /**
   * Adds a late value to the edit that was committed last, as part of the same step. Ignored after an undo of that
   * step, or after a later step.
   * @throws Error when the value is not allowed
   */
  amend<Value extends FieldValue>(update: FieldUpdate<Value>): void {
    if (!this.step) this.commit(update);
    else if (this.commands.amend(this.step, this.setTo(update))) this.step = this.commands.last;
  }

  /** Restores the values from before the first preview. */
  discard(): void {
    this.gesture?.discard();
    this.gesture = null;
  }

  private nameOf(owner: FieldTarget): string {
    return typeof this.name === 'string' ? this.name : this.name(currentOf(owner));
  }

  /** Makes the command that sets the field on all owners. @throws Error when an owner does not allow its value */
  private setTo<Value extends FieldValue>(update: FieldUpdate<Value>): SetFields {
    const edits = this.owners.map((owner, i) => {
      const name = this.nameOf(owner);
      const value = typeof update === 'function' ? update(this.previousValues[i] as Value, currentOf(owner)) : update;
      currentOf(owner).check?.(name, value);
      return { owner, name, value };
    });
    return new SetFields(this.labelOf(edits), edits);
  }

  /**
   * Label of a step in the history: 'Set intensity of Lamp to 5', 'Switched on cast shadow of Sun', 'Set position of 3
   * objects'.
   */
  private labelOf(edits: readonly FieldEdit[]): string {
    const owners = this.owners.map(currentOf);
    const field = this.nameOf(owners[0]);
    const [{ fields, ownerName }] = owners;
    const isShared = owners.every((owner) => owner.ownerName === ownerName);
    const name = this.whose?.() ?? (isShared ? ownerName : t('{count} objects', { count: owners.length }));
    const words = { field: labelOfField(field, fields[field]).toLowerCase(), name };
    const [{ value }] = edits;
    if (!edits.every((edit) => sameValue(edit.value, value))) return t('Set {field} of {name}', words);
    if (value === true) return t('Switched on {field} of {name}', words);
    if (value === false) return t('Switched off {field} of {name}', words);
    const text = valueText(fields[field] as FieldDescription, value);
    if (text === null) return t('Set {field} of {name}', words);
    return t('Set {field} of {name} to {value}', { ...words, value: text });
  }
}
