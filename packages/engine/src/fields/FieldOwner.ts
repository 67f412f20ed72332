import {
  type AssetType,
  checkFieldValue,
  type Field,
  FieldError,
  type FieldTable,
  type FieldValue,
  isTriple,
  sameValue,
} from '@farol/editing/fields';
import { savedFields } from './savedFields';

/** Checks names of assets. */
export interface AssetNames {
  /** Null when `name` is an asset of this type, else the problem with its remedy. */
  problemWith(type: AssetType, name: string): string | null;
}

/** A mutable copy of a value, for JSON. */
export function copyValue(value: FieldValue): FieldValue {
  if (!Array.isArray(value)) return value;
  return (value as readonly FieldValue[]).map(copyValue) as unknown as FieldValue;
}

/** A frozen copy of a value; -0 becomes 0, since JSON does not distinguish them. */
export function frozenCopy(value: FieldValue): FieldValue {
  if (typeof value === 'number') return value + 0;
  if (!Array.isArray(value)) return value;
  if (isTriple(value)) return Object.freeze([value[0] + 0, value[1] + 0, value[2] + 0] as const);
  return Object.freeze((value as readonly FieldValue[]).map(frozenCopy)) as FieldValue;
}

/** Temporary fields of an owner, each of which shows a part of a declared field: see `Field.viewOf`. */
export interface FieldViews {
  /** The declared fields and the views. */
  readonly fields: FieldTable;
  has(name: string): boolean;
  /** Authored (not simulated) value of a field. */
  get(name: string): FieldValue;
  /** Sets the declared field that the view is a part of. @param value - already checked */
  set(name: string, value: FieldValue): void;
}

/** Default values by field table. */
const defaults = new WeakMap<FieldTable, Record<string, FieldValue>>();

/**
 * A record of default values. Copies of one record share their hidden class and their arrays: 0.8 kB each for 90
 * fields, against 6 kB when each owner is filled field by field.
 */
function defaultValues(fields: FieldTable): Record<string, FieldValue> {
  let values = defaults.get(fields);
  if (!values) {
    values = Object.fromEntries(Object.entries(fields).map(([name, field]) => [name, frozenCopy(field.default)]));
    defaults.set(fields, values);
  }
  return { ...values };
}

/** Object with declared fields, such as a component or the settings of a scene: keeps and checks their values. */
export abstract class FieldOwner {
  private readonly values: Record<string, FieldValue>;

  constructor() {
    this.values = defaultValues(this.fields);
  }

  get fields(): FieldTable {
    return this.fieldViews?.fields ?? (this.constructor as unknown as { fields: FieldTable }).fields;
  }

  /** @internal Views besides the declared fields; null for none, undefined during construction. */
  get fieldViews(): FieldViews | null | undefined {
    return null;
  }

  /** Name used in messages, such as 'Light'. */
  abstract get ownerName(): string;

  /**
   * The present value of a field; of a simulated Transform, the simulated one.
   * @throws FieldError when there is no such field
   */
  get(name: string): FieldValue {
    return this.getAuthored(name);
  }

  /**
   * Authored value of a field: last set, saved in files, untouched by simulation.
   * @throws FieldError when there is no such field
   */
  getAuthored(name: string): FieldValue {
    if (Object.hasOwn(this.values, name)) return this.values[name];
    const views = this.fieldViews;
    if (!views?.has(name)) throw this.unknownField(name);
    return views.get(name);
  }

  /**
   * Sets a field; arrays are copied. Nothing happens when the value is the same as before.
   * @throws FieldError naming owner, field, the value and what is allowed, or an unknown asset; nothing has changed
   * then
   */
  set(name: string, value: FieldValue): void {
    this.checkValue(name, value);
    if (!Object.hasOwn(this.values, name)) return this.fieldViews!.set(name, value);
    const before = this.values[name];
    if (sameValue(before, value) && sameValue(this.get(name), value)) return;
    this.values[name] = frozenCopy(value);
    this.fieldChanged(name, before);
  }

  /** Authored values that differ from the defaults, without views (fields that show a part of another field). */
  changedValues(): Record<string, FieldValue> {
    const values: Record<string, FieldValue> = {};
    for (const { name, field } of savedFields(this.fields)) {
      const value = this.getAuthored(name);
      if (!sameValue(value, field.default)) values[name] = copyValue(value);
    }
    return values;
  }

  /** Names that asset fields are checked against; null while any name is allowed. */
  protected abstract get assetNames(): AssetNames | null;

  /** Throws unless a field can have a value. @throws FieldError */
  protected checkValue(name: string, value: FieldValue): void {
    if (!Object.hasOwn(this.values, name) && !this.fieldViews?.has(name)) throw this.unknownField(name);
    const field = this.fields[name];
    const problem = checkFieldValue(field, value) ?? this.problemWithAsset(field, value);
    if (problem) throw new FieldError(this.ownerName, name, problem);
  }

  /** Called after a field got another value. @param before - the previous authored value */
  protected abstract fieldChanged(name: string, before: FieldValue): void;

  private problemWithAsset(field: Field, value: FieldValue): string | null {
    if (field.kind !== 'asset' || typeof value !== 'string') return null;
    return this.assetNames?.problemWith(field.assetType, value) ?? null;
  }

  private unknownField(name: string): FieldError {
    return new FieldError(this.ownerName, name, `is unknown; the fields are ${Object.keys(this.fields).join(', ')}`);
  }
}
