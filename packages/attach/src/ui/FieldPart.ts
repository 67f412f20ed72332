import {
  formatNumber,
  numberDisplay,
  sharedColour,
  sharedValue,
  t,
  withCoordinate,
  withIntensity,
  withScreenColour,
} from '@farol/editing';
import type { Field, FieldValue, Vector3Tuple } from '@farol/engine/fields';
import { element } from './element';

/** A new value, or a new triple made from each owner's own. */
export type PartUpdate = number | string | boolean | ((before: Vector3Tuple) => Vector3Tuple);

/** A control of a field: the whole value, one coordinate of three, or screen colour or intensity of a colour. */
export interface FieldPart {
  readonly control: HTMLInputElement | HTMLSelectElement;
  /** Shows the values of all owners, unless the control has shown the same before: then what is typed stays. */
  show(values: readonly FieldValue[]): void;
  /** Has the next `show` write to the control in any case. */
  forget(): void;
  /** What the control says; null where it is empty because the owners differ. */
  read(): PartUpdate | null;
}

const AXES = ['x', 'y', 'z'] as const;

/**
 * The controls of a field, left to right.
 * @param id of the first control, for its label
 * @param label accessible name of the field
 */
export function makeFieldParts(field: Field, id: string, label: string): FieldPart[] {
  switch (field.kind) {
    case 'vector3':
    case 'euler':
      return AXES.map((axis, i) => numberPart(field, `${id}${axis}`, `${label} ${axis}`, i));
    case 'number':
    case 'angle':
      return [numberPart(field, id, label)];
    case 'colour':
      return [screenColourPart(id), intensityPart(t('{label} intensity', { label }))];
    case 'boolean':
      return [booleanPart(id)];
    case 'choice': {
      const select = element('select', { id }, ...field.options.map((option) => new Option(t(option), option)));
      return [textPart(select)];
    }
    default:
      return [textPart(element('input', { type: 'text', id, autocomplete: 'off' }))];
  }
}

/**
 * A part that shows a text.
 * @param textOf the text of the owners' values; null where they differ
 * @param write shows the text
 */
function part(
  control: FieldPart['control'],
  textOf: (values: readonly FieldValue[]) => string | null,
  write: (text: string | null, values: readonly FieldValue[]) => void,
  read: (isMixed: boolean) => PartUpdate | null,
): FieldPart {
  let shown: string | null | undefined;
  return {
    control,
    show(values) {
      const text = textOf(values);
      if (text === shown) return;
      shown = text;
      control.toggleAttribute('data-mixed', text === null);
      write(text, values);
    },
    forget: () => void (shown = undefined),
    read: () => read(shown === null),
  };
}

/** An input of numbers; an empty one is NaN, which no field allows, or leaves differing values as they are. */
function numericPart(
  control: HTMLInputElement,
  textOf: (values: readonly FieldValue[]) => string | null,
  updateOf: (shown: number) => PartUpdate,
): FieldPart {
  const write = (text: string | null): void => {
    control.value = text ?? '';
    control.placeholder = text === null ? '—' : '';
  };
  return part(control, textOf, write, (isMixed) => {
    if (control.value === '') return isMixed ? null : updateOf(Number.NaN);
    return updateOf(Number(control.value));
  });
}

/** @param axis of a vector or of Euler angles; none for a single number */
function numberPart(field: Field, id: string, label: string, axis?: number): FieldPart {
  const { min = '', max = '', step, toShown, fromShown } = numberDisplay(field);
  const control = element('input', { type: 'number', id, min, max, step, 'aria-label': label });
  const text = (value: number | null): string | null =>
    value === null ? null : formatNumber(toShown(value), axis === undefined ? 'long' : 'short');
  return numericPart(
    control,
    (values) => {
      const { value, parts } = sharedValue(values);
      if (axis === undefined) return text(value as number | null);
      return text((value as Vector3Tuple | null)?.[axis] ?? parts![axis]);
    },
    (shown) => (axis === undefined ? fromShown(shown) : withCoordinate(axis, fromShown(shown))),
  );
}

function screenColourPart(id: string): FieldPart {
  const control = element('input', { type: 'color', id });
  return part(
    control,
    (values) => sharedColour(values as readonly Vector3Tuple[]).hex,
    // this control cannot be empty: it has the colour of what was chosen last
    (text, values) => void (control.value = text ?? sharedColour([values.at(-1) as Vector3Tuple]).hex!),
    () => withScreenColour(control.value),
  );
}

/** The factor by which a colour is brighter than a screen. */
function intensityPart(label: string): FieldPart {
  const control = element('input', { type: 'number', min: 1, step: 0.1, 'aria-label': label, className: 'intensity' });
  return numericPart(
    control,
    (values) => {
      const { intensity } = sharedColour(values as readonly Vector3Tuple[]);
      return intensity === null ? null : formatNumber(intensity, 'short');
    },
    (shown) => withIntensity(shown),
  );
}

function booleanPart(id: string): FieldPart {
  const control = element('input', { type: 'checkbox', id });
  const textOf = (values: readonly FieldValue[]): string | null => {
    const { value, mixed } = sharedValue(values);
    return mixed ? null : String(value);
  };
  const write = (text: string | null): void => {
    control.checked = text === 'true';
    control.indeterminate = text === null;
  };
  return part(control, textOf, write, () => control.checked);
}

/** A text, or one of several. */
function textPart(control: HTMLInputElement | HTMLSelectElement): FieldPart {
  const textOf = (values: readonly FieldValue[]): string | null => {
    const { value, mixed } = sharedValue(values);
    return mixed ? null : String(value);
  };
  const write = (text: string | null): void => {
    control.value = text ?? '';
    if (control instanceof HTMLInputElement) control.placeholder = text === null ? '—' : '';
  };
  return part(control, textOf, write, () => control.value);
}
