import {
  addToNumber,
  formatNumber,
  isComposing,
  numberDisplay,
  type NumberRange,
  readNumberInRange,
  sharedColour,
  sharedValue,
  splitColour,
  stepFactor,
  suitsSlider,
  t,
  valueOnSlider,
  withCoordinate,
  withIntensity,
  withScreenColour,
} from '@farol/editing';
import type { Field, FieldValue, Vector3Tuple } from '@farol/editing/fields';
import { element } from './element';

/** A new value, or a function from each owner's value to the new one. */
export type PartUpdate =
  | number
  | string
  | boolean
  | ((before: number) => number)
  | ((before: Vector3Tuple) => Vector3Tuple);

/** A control of a field: the whole value, one coordinate of three, or screen colour or intensity of a colour. */
export interface FieldPart {
  readonly control: HTMLInputElement | HTMLSelectElement;
  /** Displays the values of all owners; text being typed is kept if the values have not changed since. */
  show(values: readonly FieldValue[]): void;
  /** Makes the next `show` write to the control even if the value is equal. */
  forget(): void;
  /**
   * Value of the control: null when empty, undefined for an unfinished number.
   * @throws Error that says why it is no number
   */
  read(): PartUpdate | null | undefined;
  /** Change of a number by a drag of its label; absent for controls of other kinds. @param steps - dragged so far */
  readonly scrubbed?: (steps: number) => (before: number) => number;
  /** Reason that the control's text is no valid value; null when valid. */
  readonly unfinished?: () => string | null;
}

const AXES = ['x', 'y', 'z'] as const;

/**
 * Makes the controls of a field, left to right.
 * @param id - element id of the first control, for its label
 * @param label - accessible name of the field
 */
export function makeFieldParts(field: Field, id: string, label: string): FieldPart[] {
  switch (field.kind) {
    case 'vector3':
    case 'euler':
      return AXES.map((axis, i) => numberPart(field, `${id}${axis}`, `${label} ${axis}`, i));
    case 'number':
    case 'angle': {
      const slider = sliderPart(field);
      return [numberPart(field, id, label), ...(slider ? [slider] : [])];
    }
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
 * Makes a control that displays a text.
 * @param textOf - returns the text of the owners' values; null when they differ
 * @param write - displays the text
 */
function part(
  control: FieldPart['control'],
  textOf: (values: readonly FieldValue[]) => string | null,
  write: (text: string | null, values: readonly FieldValue[]) => void,
  read: () => PartUpdate | null | undefined,
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
    read,
  };
}

/** A number in the displayed unit, or a function from the previous number to the new one. */
type Typed = number | ((before: number) => number);

/**
 * Makes an input that accepts expressions, units and `+=`, as number fields of Farol's own editor do. Arrow keys step.
 * @param textOf - returns the text of the owners' values; decimals are limited by a given step
 * @param updateOf - converts a typed number, or function, to the update of the field
 */
function numericPart(
  range: NumberRange & { readonly step: number },
  properties: Record<string, unknown>,
  textOf: (values: readonly FieldValue[], step?: number) => string | null,
  updateOf: (shown: Typed) => PartUpdate,
): FieldPart {
  const { min, max, step } = range;
  const limits = {
    ...(min !== undefined && { 'aria-valuemin': min }),
    ...(max !== undefined && { 'aria-valuemax': max }),
  };
  const control = element('input', {
    ...{ type: 'text', inputMode: 'decimal', role: 'spinbutton', autocomplete: 'off', spellcheck: false },
    ...limits,
    ...properties,
  });
  const write = (text: string | null): void => {
    control.value = text ?? '';
    control.placeholder = text === null ? '—' : '';
    if (text === null) control.removeAttribute('aria-valuenow');
    else control.setAttribute('aria-valuenow', text);
  };
  let isStepped = false;
  control.addEventListener('keydown', (event) => {
    if (isComposing(event) || (event.key !== 'ArrowUp' && event.key !== 'ArrowDown')) return;
    const read = readNumberInRange(control.value, range);
    if (read.problem !== null || read.isRelative) return;
    event.preventDefault();
    isStepped = true;
    const by = step * stepFactor(event);
    control.value = String(addToNumber(read.valueFor(0), event.key === 'ArrowUp' ? by : -by, range));
    control.dispatchEvent(new Event('input', { bubbles: true }));
  });
  // stepping by arrow keys causes no `change` event: the value is committed on keyup
  control.addEventListener('keyup', ({ key }) => {
    // macOS sends no keyup for an arrow key released while Command is down
    if (!isStepped || (key !== 'ArrowUp' && key !== 'ArrowDown' && key !== 'Meta')) return;
    isStepped = false;
    control.dispatchEvent(new Event('change', { bubbles: true }));
  });
  // all decimals are displayed while the field is edited
  let hasFocus = false;
  let last: readonly FieldValue[] | null = null;
  const text = (values: readonly FieldValue[]): string | null => textOf((last = values), hasFocus ? undefined : step);
  control.addEventListener('focus', () => {
    hasFocus = true;
    if (last) made.show(last);
    control.select();
  });
  control.addEventListener('blur', () => {
    const isUntouched = last !== null && control.value === textOf(last);
    hasFocus = false;
    if (isUntouched) made.show(last!);
  });
  const read = (): PartUpdate | null | undefined => {
    if (control.value.trim() === '') return null;
    const typed = readNumberInRange(control.value, range);
    if (typed.problem === null) return updateOf(typed.isRelative ? typed.valueFor : typed.valueFor(0));
    if (typed.isIncomplete) return undefined;
    throw new Error(typed.problem);
  };
  const unfinished = (): string | null =>
    control.value.trim() === '' ? null : readNumberInRange(control.value, range).problem;
  const made = part(control, text, write, read);
  return { ...made, unfinished };
}

/** @param axis - coordinate of a vector or of Euler angles; none for a single number */
function numberPart(field: Field, id: string, label: string, axis?: number): FieldPart {
  const { toShown, fromShown, ...range } = numberDisplay(field);
  const text = (value: number | null, step?: number): string | null =>
    value === null ? null : formatNumber(toShown(value), axis === undefined ? 'long' : 'short', step);
  const inField = (shown: Typed): number | ((before: number) => number) =>
    typeof shown === 'function' ? (before) => fromShown(shown(toShown(before))) : fromShown(shown);
  const made = numericPart(
    range,
    { id, 'aria-label': label },
    (values, step) => {
      const { value, parts } = sharedValue(values);
      if (axis === undefined) return text(value as number | null, step);
      return text((value as Vector3Tuple | null)?.[axis] ?? parts![axis]);
    },
    (shown) => (axis === undefined ? inField(shown) : withCoordinate(axis, inField(shown))),
  );
  if (axis !== undefined) return made;
  const scrubbed = (steps: number) => (before: number) =>
    fromShown(addToNumber(toShown(before), steps * range.step, range));
  return { ...made, scrubbed };
}

/**
 * Makes a slider from the smallest to the largest value, for pointers; keys go to the number beside it. Null for an
 * unsuitable range.
 */
function sliderPart(field: Field): FieldPart | null {
  const { toShown, fromShown, ...range } = numberDisplay(field);
  const { min, max, step } = range;
  if (min === undefined || max === undefined || !suitsSlider(range)) return null;
  const control = element('input', {
    type: 'range',
    min: '0',
    max: '1',
    step: 'any',
    tabIndex: -1,
    'aria-hidden': true,
  });
  const textOf = (values: readonly FieldValue[]): string | null => {
    const { value, mixed } = sharedValue(values);
    return mixed ? null : String((toShown(value as number) - min) / (max - min));
  };
  const write = (text: string | null): void => void (control.value = text ?? '0');
  return part(control, textOf, write, () => fromShown(valueOnSlider(control.valueAsNumber, { min, max, step })));
}

function screenColourPart(id: string): FieldPart {
  const control = element('input', { type: 'color', id });
  return part(
    control,
    (values) => sharedColour(values as readonly Vector3Tuple[]).hex,
    // a colour input cannot be empty: when colours differ it displays that of the object selected last
    (text, values) => void (control.value = text ?? sharedColour([values.at(-1) as Vector3Tuple]).hex!),
    () => withScreenColour(control.value),
  );
}

/** Makes the control of a colour's intensity: its factor relative to a colour that a screen can display. */
function intensityPart(label: string): FieldPart {
  return numericPart(
    { min: 1, step: 0.1, unit: '×' },
    { 'aria-label': label, className: 'intensity' },
    (values) => {
      const { intensity } = sharedColour(values as readonly Vector3Tuple[]);
      return intensity === null ? null : formatNumber(intensity, 'short');
    },
    (shown) =>
      typeof shown === 'function'
        ? (before: Vector3Tuple) => withIntensity(shown(splitColour(before).intensity))(before)
        : withIntensity(shown),
  );
}

/** Text of the value that all owners share; null when they differ. */
function textOf(values: readonly FieldValue[]): string | null {
  const { value, mixed } = sharedValue(values);
  return mixed ? null : String(value);
}

function booleanPart(id: string): FieldPart {
  const control = element('input', { type: 'checkbox', id });
  const write = (text: string | null): void => {
    control.checked = text === 'true';
    control.indeterminate = text === null;
  };
  return part(control, textOf, write, () => control.checked);
}

/** Makes the control of a text, or of a choice. */
function textPart(control: HTMLInputElement | HTMLSelectElement): FieldPart {
  const write = (text: string | null): void => {
    control.value = text ?? '';
    if (control instanceof HTMLInputElement) control.placeholder = text === null ? '—' : '';
  };
  return part(control, textOf, write, () => control.value);
}
