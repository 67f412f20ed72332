import { t } from '@farol/editing';
import { sectionsOf } from '../fields/sectionsOf';
import type { Session } from '../model/Session';
import { element } from '../ui/element';
import { FieldInput } from '../ui/FieldInput';

/** The values of the selected objects: shown as they change, edited together and with undo. */
export class Inspector {
  readonly element = element('section', { className: 'inspector', 'aria-label': t('Inspector'), tabIndex: 0 });
  private inputs: FieldInput[] = [];
  private readonly end: () => void;

  constructor(private readonly session: Session) {
    this.end = session.selection.changed.subscribe(() => this.build());
    this.build();
  }

  /** Brings what is shown up to date. */
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
    if (selection.length === 0) {
      const hint = t('Nothing is selected: choose an object in the tree, or click one in the picture.');
      this.element.replaceChildren(element('p', { className: 'hint' }, hint));
      return;
    }
    this.element.replaceChildren(
      ...(selection.length > 1
        ? [element('p', { className: 'hint' }, t('{count} objects', { count: selection.length }))]
        : []),
      ...sectionsOf(selection).map(({ title, owners }) => {
        const inputs = Object.keys(owners[0].fields).map((name) => new FieldInput(this.session, owners, name));
        this.inputs.push(...inputs);
        return element(
          'details',
          { open: true },
          element('summary', {}, title),
          ...inputs.map((input) => input.element),
        );
      }),
    );
  }
}
