import { describeField, FieldGesture, type FieldUpdate, labelOfField, numberDisplay } from '@farol/editing';
import { FieldError } from '@farol/engine/fields';
import type { Object3D } from 'three';
import type { PropertyOwner } from '../fields/Property';
import type { Session } from '../model/Session';
import { type FieldPart, makeFieldParts } from './FieldPart';
import { element } from './element';

let count = 0;

/**
 * A row of the inspector: label and controls of one field, of one object or of several. A control previews while one types
 * or drags, commits when the browser says that its value has changed, discards on Escape, and marks a value that the field
 * does not allow. Where the values of several objects differ, the controls say so, and what is not touched stays as each
 * object has it.
 */
export class FieldInput {
  readonly element: HTMLElement;
  private readonly label: string;
  private readonly parts: readonly FieldPart[];
  private readonly gesture: FieldGesture<Object3D>;

  /** @param owners at least one, all with the field */
  constructor(
    session: Session,
    private readonly owners: readonly PropertyOwner[],
    private readonly name: string,
  ) {
    const field = owners[0].fields[name];
    const id = `field-${++count}`;
    this.label = labelOfField(name, field);
    this.gesture = new FieldGesture(session.commands, owners, name);
    this.parts = makeFieldParts(field, id, this.label);
    const isTriple = this.parts.length === 3;
    const description = describeField(field);
    const heading = { className: 'label', title: description };
    this.element = element(
      'div',
      isTriple ? { className: 'field', role: 'group', 'aria-label': this.label } : { className: 'field' },
      isTriple ? element('span', heading, this.label) : element('label', { ...heading, htmlFor: id }, this.label),
      element('span', { className: 'controls' }, ...this.parts.map(({ control }) => control)),
      element('span', { className: 'unit', 'aria-hidden': true }, this.unit),
    );
    for (const part of this.parts) {
      part.control.setAttribute('aria-description', description);
      part.control.addEventListener('input', () => this.preview(session, part));
      part.control.addEventListener('change', () => this.close());
    }
    this.element.addEventListener('keydown', (event) => {
      if (event.key !== 'Escape' || !this.gesture.isOpen) return;
      this.gesture.discard();
      this.close();
    });
    this.refresh();
  }

  /** Shows the value as it is now, unless it is being edited. */
  refresh(): void {
    if (this.gesture.isOpen) return;
    const values = this.owners.map((owner) => owner.getAuthored(this.name));
    for (const part of this.parts) part.show(values);
  }

  /** Commits an edit that is under way. */
  close(): void {
    this.gesture.commit();
    for (const part of this.parts) {
      mark(part, '');
      part.forget();
    }
    this.refresh();
  }

  private get unit(): string {
    const field = this.owners[0].fields[this.name];
    return field.kind === 'colour' ? '×' : (numberDisplay(field).unit ?? '');
  }

  private preview(session: Session, part: FieldPart): void {
    const { gesture } = this;
    // an undo has ended the edit: what is typed now is another one
    if (!gesture.isOpen) gesture.commit();
    let problem = '';
    try {
      const update = part.read();
      if (update === null) gesture.discard();
      else gesture.preview(update as FieldUpdate);
    } catch (error) {
      problem = error instanceof FieldError ? `${this.label} ${error.problem}` : messageOf(error);
    }
    mark(part, problem);
    session.edited.emit();
  }
}

const messageOf = (error: unknown): string => (error instanceof Error ? error.message : String(error));

/** Marks a control as wrong, with the reason as its tooltip. @param problem '' for none */
function mark({ control }: FieldPart, problem: string): void {
  control.setAttribute('aria-invalid', String(problem !== ''));
  control.title = problem;
}
