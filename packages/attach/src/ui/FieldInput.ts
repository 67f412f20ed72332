import { checkFieldValue, type Field, type FieldValue, type Vector3Tuple } from '@farol/engine';
import type { Session } from '../model/Session';
import { type BoundProperty, PropertyEdit } from '../fields/Property';
import { element } from './element';
import { linearColour, screenColour } from './screenColour';

type Control = HTMLInputElement | HTMLSelectElement;

const DEGREE = Math.PI / 180;
const AXES = ['x', 'y', 'z'] as const;
let count = 0;

/**
 * A row of the inspector: label and controls of one property. It previews while one types or drags, commits when the
 * control does, discards on Escape, and marks a value that the field does not allow.
 */
export class FieldInput {
  readonly element: HTMLElement;
  private readonly controls: Control[];
  private readonly shown: string[] = [];
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
    const texts = this.textsOf(this.property.get());
    this.controls.forEach((control, i) => {
      if (texts[i] === this.shown[i]) return;
      this.shown[i] = texts[i];
      if (control instanceof HTMLInputElement && control.type === 'checkbox') control.checked = texts[i] === 'true';
      else control.value = texts[i];
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
    const problem = checkFieldValue(this.property.field, value);
    this.mark(problem);
    if (problem !== null) return;
    this.edit ??= new PropertyEdit(this.session, this.property);
    this.edit.preview(value);
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

  private read(): FieldValue {
    const { controls } = this;
    const { kind } = this.property.field;
    const [first] = controls;
    const numbers = () => controls.map((control) => (control.value === '' ? Number.NaN : Number(control.value)));
    switch (kind) {
      case 'vector3':
        return numbers() as unknown as Vector3Tuple;
      case 'euler':
        return numbers().map((degrees) => degrees * DEGREE) as unknown as Vector3Tuple;
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
