import { isComposing, t, wordsOfFilter } from '@farol/editing';
import { sectionsOf } from '../fields/sectionsOf';
import type { Session } from '../model/Session';
import { element } from '../ui/element';
import { FieldInput } from '../ui/FieldInput';

/** Fields of the selected objects, edited together, with undo; displayed values follow changes. */
export class Inspector {
  readonly element = element('section', { className: 'inspector', 'aria-label': t('Inspector'), tabIndex: 0 });
  private readonly search = element('input', {
    ...{ type: 'search', placeholder: t('Find a field'), autocomplete: 'off', spellcheck: false },
    'aria-label': t('Find a field'),
  });
  private readonly none = element('p', { className: 'hint', hidden: true }, t('No field matches the search.'));
  private sections: { title: string; details: HTMLElement; inputs: FieldInput[] }[] = [];
  private inputs: FieldInput[] = [];
  private readonly end: () => void;

  constructor(private readonly session: Session) {
    this.end = session.selection.changed.subscribe(() => this.build());
    this.search.addEventListener('input', () => this.filter());
    this.search.addEventListener('keydown', (event) => {
      if (isComposing(event) || event.key !== 'Escape') return;
      this.search.value = '';
      this.filter();
      this.element.focus();
    });
    this.build();
  }

  /** Updates the shown values. */
  refresh(): void {
    for (const input of this.inputs) input.refresh();
  }

  dispose(): void {
    this.end();
    this.close();
  }

  private close(): void {
    for (const input of this.inputs) input.close();
  }

  private build(): void {
    this.close();
    const { items: selection } = this.session.selection;
    this.inputs = [];
    this.sections = [];
    if (selection.length === 0) {
      const hint = t('Nothing is selected: choose an object in the tree, or click one in the picture.');
      this.element.replaceChildren(element('p', { className: 'hint' }, hint));
      return;
    }
    this.sections = sectionsOf(selection).map(({ title, owners }) => {
      const inputs = Object.keys(owners[0].fields).map((name) => new FieldInput(this.session, owners, name));
      this.inputs.push(...inputs);
      const rows = inputs.map((input) => input.element);
      return { title, inputs, details: element('details', { open: true }, element('summary', {}, title), ...rows) };
    });
    const count = element('p', { className: 'hint' }, t('{count} objects', { count: selection.length }));
    this.element.replaceChildren(
      this.search,
      ...(selection.length > 1 ? [count] : []),
      ...this.sections.map(({ details }) => details),
      this.none,
    );
    this.filter();
  }

  /** Shows the fields that match the filter text, and the sections that contain any. */
  private filter(): void {
    const words = wordsOfFilter(this.search.value);
    for (const { title, details, inputs } of this.sections)
      details.hidden = inputs.filter((input) => input.filter(words, title)).length === 0;
    this.none.hidden = this.sections.some(({ details }) => !details.hidden);
  }
}
