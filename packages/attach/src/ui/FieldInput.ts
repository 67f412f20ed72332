import type { Field, FieldValue, Vector3Tuple } from '@farol/engine/fields';
import type { Session } from '../model/Session';
import type { BoundProperty } from '../fields/Property';
import { type PartialValue, PropertyEdit } from '../fields/PropertyEdit';
import { element } from './element';
import { linearColour, screenColour } from './screenColour';

type Control = HTMLInputElement | HTMLSelectElement;

const DEGREE = Math.PI / 180;
const AXES = ['x', 'y', 'z'] as const;
let count = 0;

/**
 * A row of the inspector: label and controls of one property, of one object or of several. It previews while one types or
 * drags, commits when the control does, discards on Escape, and marks a value that the field does not allow. Of values that
 * differ it shows that they do; what is not touched stays as each has it.
 */
export class FieldInput {
  readonly element: HTMLElement;
  private readonly controls: Control[];
  /** The text of each control; null where values differ. */
  private readonly shown: (string | null)[] = [];
  private edit: PropertyEdit | null = null;

  constructor(
    private readonly session: Session,
    private readonly property: BoundProperty,
  ) {
    const { field, label } = property;
    const id = `field-${++count}`;
    this.controls = this.makeControls(field, id, label);
    const single = this.controls.length === 1;
    const name = element(single ? 'label' : 'span', { className: 'label', title: field.help }, label);
    if (name instanceof HTMLLabelElement) name.htmlFor = id;
    const unit = field.kind === 'angle' || field.kind === 'euler' ? '°' : 'unit' in field ? field.unit : undefined;
    this.element = element(
      'div',
      single ? { className: 'field' } : { className: 'field', role: 'group', 'aria-label': label },
      name,
      element('span', { className: 'controls' }, ...this.controls),
      element('span', { className: 'unit', 'aria-hidden': true }, unit ?? ''),
    );
    this.element.addEventListener('input', () => this.preview());
    this.element.addEventListener('change', () => this.close());
    this.element.addEventListener('keydown', (event) => {
      if (event.key !== 'Escape' || !this.edit) return;
      this.edit.discard();
      this.edit = null;
      this.refresh();
    });
    this.refresh();
  }

  /** Shows the value as it is now, unless it is being edited. */
  refresh(): void {
    if (this.edit) return;
    const all = this.property.get().map((value) => this.textsOf(value));
    this.controls.forEach((control, i) => {
      const last = all.at(-1)![i];
      const text = all.every((texts) => texts[i] === last) ? last : null;
      if (text === this.shown[i]) return;
      this.shown[i] = text;
      show(control, text, last);
    });
  }

  /** Commits an edit that is under way. */
  close(): void {
    const { edit } = this;
    this.edit = null;
    edit?.commit();
    this.mark(null);
    this.shown.length = 0;
    this.refresh();
  }

  private preview(): void {
    const value = this.read();
    const edit = this.edit ?? new PropertyEdit(this.session, this.property);
    const problem = edit.problemWith(value);
    this.mark(problem);
    if (problem !== null) return;
    this.edit = edit;
    edit.preview(value);
  }

  /** Marks the controls as wrong, with the reason as their tooltip. */
  private mark(problem: string | null): void {
    for (const control of this.controls) {
      control.setAttribute('aria-invalid', String(problem !== null));
      control.title = problem === null ? '' : `${this.property.label} ${problem}`;
    }
  }

  private makeControls(field: Field, id: string, label: string): Control[] {
    const number = (name: string, suffix: string) => {
      const { min, max, step } = field as { min?: number; max?: number; step?: number };
      const inDegrees = field.kind === 'angle' || field.kind === 'euler';
      const shown = (value: number | undefined) => (value === undefined ? '' : inDegrees ? value / DEGREE : value);
      return element('input', {
        ...{ type: 'number', id: id + suffix, min: shown(min), max: shown(max), 'aria-label': name },
        step: inDegrees ? 1 : (step ?? 1),
      });
    };
    switch (field.kind) {
      case 'vector3':
      case 'euler':
        return AXES.map((axis) => number(`${label} ${axis}`, axis));
      case 'number':
      case 'angle':
        return [number(label, '')];
      case 'boolean':
        return [element('input', { type: 'checkbox', id })];
      case 'colour':
        return [element('input', { type: 'color', id })];
      case 'choice':
        return [element('select', { id }, ...field.options.map((option) => new Option(option, option)))];
      default:
        return [element('input', { type: 'text', id, autocomplete: 'off' })];
    }
  }

  /** Of a vector, null where the values differ and nothing has been typed. */
  private read(): PartialValue {
    const { controls } = this;
    const { kind } = this.property.field;
    const [first] = controls;
    const numbers = () => controls.map(({ value }) => (value === '' ? Number.NaN : Number(value)));
    const components = (factor: number) =>
      numbers().map((each, i) => (Number.isNaN(each) && this.shown[i] === null ? null : each * factor));
    switch (kind) {
      case 'vector3':
        return components(1);
      case 'euler':
        return components(DEGREE);
      case 'number':
        return numbers()[0];
      case 'angle':
        return numbers()[0] * DEGREE;
      case 'boolean':
        return (first as HTMLInputElement).checked;
      case 'colour':
        return linearColour(first.value);
      default:
        return first.value;
    }
  }

  private textsOf(value: FieldValue): string[] {
    const { kind } = this.property.field;
    const text = (number: number) => String(Number(number.toFixed(4)));
    switch (kind) {
      case 'vector3':
        return (value as Vector3Tuple).map(text);
      case 'euler':
        return (value as Vector3Tuple).map((radians) => text(radians / DEGREE));
      case 'number':
        return [text(value as number)];
      case 'angle':
        return [text((value as number) / DEGREE)];
      case 'colour':
        return [screenColour(value as Vector3Tuple)];
      default:
        return [String(value)];
    }
  }
}

/**
 * @param text null where values differ
 * @param last what the object that was chosen last has, for a control that cannot be empty
 */
function show(control: Control, text: string | null, last: string): void {
  control.toggleAttribute('data-mixed', text === null);
  if (!(control instanceof HTMLInputElement)) control.value = text ?? '';
  else if (control.type === 'checkbox') {
    control.checked = text === 'true';
    control.indeterminate = text === null;
  } else {
    control.value = text ?? (control.type === 'color' ? last : '');
    control.placeholder = text === null ? '—' : '';
  }
}
