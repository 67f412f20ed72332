import {
  describeField,
  FieldGesture,
  type FieldUpdate,
  isComposing,
  labelOfField,
  matchesFilter,
  numberDisplay,
} from '@farol/editing';
import { FieldError } from '@farol/editing/fields';
import type { Object3D } from 'three';
import type { PropertyOwner } from '../fields/Property';
import type { Session } from '../model/Session';
import { type FieldPart, makeFieldParts } from './FieldPart';
import { scrub } from './scrub';
import { element } from './element';

let count = 0;

/**
 * A row of the inspector: label and controls of one field of one or several objects. A control previews while the user
 * types or drags, commits on the browser's `change` event, discards on Escape, and marks values that the field does not
 * allow. Where the values of several objects differ, the control says so; parts that are not edited keep each object's
 * value.
 */
export class FieldInput {
  readonly element: HTMLElement;
  private readonly label: string;
  private readonly parts: readonly FieldPart[];
  private readonly gesture: FieldGesture<Object3D>;
  private readonly problem = element('p', { className: 'problem', role: 'alert', hidden: true });

  /** @param owners - objects whose field is edited: at least one */
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
    const title = isTriple
      ? element('span', heading, this.label)
      : element('label', { ...heading, htmlFor: id }, this.label);
    this.element = element(
      'div',
      isTriple ? { className: 'field', role: 'group', 'aria-label': this.label } : { className: 'field' },
      title,
      element('span', { className: 'controls' }, ...this.parts.map(({ control }) => control)),
      element('span', { className: 'unit', 'aria-hidden': true }, this.unit),
      this.problem,
    );
    for (const part of this.parts) {
      part.control.setAttribute('aria-description', description);
      part.control.addEventListener('input', () => this.preview(session, part));
      part.control.addEventListener('change', () => this.takeOver(part));
    }
    const [{ scrubbed }] = this.parts;
    if (scrubbed) {
      scrub(
        title,
        (steps) => this.take(session, null, scrubbed(steps) as FieldUpdate),
        (keeps) => {
          if (!keeps) this.gesture.discard();
          this.close();
          session.edited.emit();
        },
      );
    }
    this.element.addEventListener('keydown', (event) => this.key(event));
    this.refresh();
  }

  /** Displays the present value, unless it is being edited. */
  refresh(): void {
    if (this.gesture.isOpen || this.parts.some(isWrong)) return;
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
    this.tell('');
    this.refresh();
  }

  /**
   * Commits the typed text if it is a number; otherwise the text stays, marked with the reason, and the value is
   * unchanged.
   */
  private takeOver(part: FieldPart): void {
    const problem = part.unfinished?.() ?? null;
    if (problem === null) {
      this.close();
      return;
    }
    this.gesture.discard();
    mark(part, problem);
    this.tell(problem);
  }

  /**
   * Handles Enter, which commits the typed value, and Escape, which discards it; both leave the field, so that the
   * editor gets the keys again.
   */
  private key(event: KeyboardEvent): void {
    const { key, target } = event;
    if (isComposing(event)) return;
    if (key !== 'Enter' && key !== 'Escape') return;
    const part = this.parts.find(({ control }) => control === target);
    if (key === 'Escape') {
      this.gesture.discard();
      this.close();
    }
    if (!(target instanceof HTMLInputElement) || target.type !== 'text') return;
    if (key === 'Enter' && part?.unfinished?.()) {
      this.takeOver(part);
      return;
    }
    // moves the focus to the panel, which gets the keys from now on
    const panel = this.element.closest<HTMLElement>('[tabindex]');
    if (panel) panel.focus();
    else target.blur();
  }

  private tell(problem: string): void {
    this.problem.textContent = problem;
    this.problem.hidden = problem === '';
  }

  private get unit(): string {
    const field = this.owners[0].fields[this.name];
    return field.kind === 'colour' ? '×' : (numberDisplay(field).unit ?? '');
  }

  /** Whether a filter matches the field: each word is in its label, its name or the title of its section. */
  filter(words: readonly string[], section: string): boolean {
    const isFound = matchesFilter(words, [this.label, this.name, section]);
    this.element.hidden = !isFound;
    return isFound;
  }

  private preview(session: Session, part: FieldPart): void {
    let update: FieldUpdate | null | undefined;
    try {
      update = part.read() as FieldUpdate | null | undefined;
    } catch (error) {
      this.refuse(session, part, messageOf(error));
      return;
    }
    if (update !== undefined) this.take(session, part, update);
  }

  /**
   * Previews an edit.
   * @param part - control in which the value is entered, which is not updated; null for a drag of the label
   * @param update - new value; null discards the preview
   */
  private take(session: Session, part: FieldPart | null, update: FieldUpdate | null): void {
    const { gesture } = this;
    // an undo has ended the gesture: further typing begins a new one
    if (!gesture.isOpen) gesture.commit();
    try {
      if (update === null) gesture.discard();
      else gesture.preview(update);
    } catch (error) {
      this.refuse(
        session,
        part ?? this.parts[0],
        error instanceof FieldError ? `${this.label} ${error.problem}` : messageOf(error),
      );
      return;
    }
    const values = this.owners.map((owner) => owner.getAuthored(this.name));
    for (const each of this.parts) if (each !== part) each.show(values);
    if (part) mark(part, '');
    this.tell('');
    session.edited.emit();
  }

  private refuse(session: Session, part: FieldPart, problem: string): void {
    // restores the value from before the edit, not the last valid preview
    this.gesture.discard();
    mark(part, problem);
    this.tell(problem);
    session.edited.emit();
  }
}

const messageOf = (error: unknown): string => (error instanceof Error ? error.message : String(error));

const isWrong = ({ control }: FieldPart): boolean => control.getAttribute('aria-invalid') === 'true';

/** Marks a control as invalid, with the reason as its tooltip. @param problem - '' for none */
function mark({ control }: FieldPart, problem: string): void {
  control.setAttribute('aria-invalid', String(problem !== ''));
  control.title = problem;
}
