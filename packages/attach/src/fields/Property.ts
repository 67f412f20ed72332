import type { FieldTarget } from '@farol/editing';
import { checkFieldValue, type Field, FieldError, type FieldValue } from '@farol/editing/fields';

/**
 * Property of a three object that the inspector edits: its field (kind, unit, range, help) with a getter and a setter.
 */
export interface Property<Target = unknown> {
  readonly name: string;
  readonly field: Field;
  get(target: Target): FieldValue;
  set(target: Target, value: FieldValue): void;
}

/**
 * An object or a material of the page with some of its properties, as a target of edits. The page may hold values that
 * a user could not enter, such as a camera without a far plane; undo restores these too.
 */
export class PropertyOwner implements FieldTarget {
  readonly fields: Readonly<Record<string, Field>>;
  private readonly properties: ReadonlyMap<string, Property>;

  /** @param ownerName - name or type of the object, for labels of the history */
  constructor(
    readonly ownerName: string,
    private readonly target: object,
    properties: readonly Property<never>[],
  ) {
    this.properties = new Map(properties.map((property) => [property.name, property as Property]));
    this.fields = Object.fromEntries(properties.map(({ name, field }) => [name, field]));
  }

  getAuthored(name: string): FieldValue {
    return this.properties.get(name)!.get(this.target);
  }

  set(name: string, value: FieldValue): void {
    this.properties.get(name)!.set(this.target, value);
  }

  /** @throws FieldError for a value that the field does not allow */
  check(name: string, value: FieldValue): void {
    const problem = checkFieldValue(this.fields[name], value);
    if (problem !== null) throw new FieldError(this.ownerName, name, problem);
  }
}
