import type { CustomField, FieldTable, FieldType, FieldValue } from '@farol/editing/fields';
import { Component } from './Component';
import type { ComponentClass, ComponentData } from './ComponentClass';

/** Kind of a field whose declaration is unknown. */
const data: FieldType = { name: 'data', allows: 'a number, text, true, false, null or [x, y, z]', check: () => true };

/**
 * A component of an unknown class: does nothing, but keeps and saves the data from a file, or from a class removed from
 * the registry. Each has a class of its own, with the fields of its data.
 */
export abstract class UnknownComponent extends Component {
  static override readonly help: string = 'The script or plugin of this component is missing: its data are kept.';
}

/** Makes a class for a component with the data of an unknown class. */
export function unknownClass({ type, version, values }: ComponentData): ComponentClass<UnknownComponent> {
  // no default, so that every value is saved
  const fieldOf = (): CustomField => ({
    kind: 'custom',
    type: data,
    default: undefined as unknown as FieldValue,
    help: 'Kept as it is.',
    readOnly: true,
  });
  const table: FieldTable = Object.fromEntries(Object.keys(values).map((name) => [name, fieldOf()]));
  class Unknown extends UnknownComponent {
    static override readonly typeName = type;
    static override readonly version = version;
    static override readonly fields = table;
  }
  return Unknown;
}

/** Makes a component, on no object yet, with the data of an unknown class. */
export function makeUnknownComponent(data: ComponentData): UnknownComponent {
  const component = new (unknownClass(data))();
  for (const name of Object.keys(data.values)) component.set(name, data.values[name]);
  return component;
}
