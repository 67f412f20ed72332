import type { Session } from '../model/Session';
import { element } from '../ui/element';
import type { Gizmo, GizmoMode } from '../viewport/Gizmo';

const modes: Record<GizmoMode, string> = { translate: 'Move', rotate: 'Turn', scale: 'Scale' };

/** Buttons: undo and redo, what the gizmo does, and closing. */
export class Bar {
  readonly element = element('div', { className: 'bar', role: 'toolbar', 'aria-label': 'Editor' });
  private readonly undo: HTMLButtonElement;
  private readonly redo: HTMLButtonElement;
  private readonly ends: (() => void)[];

  /** @param toggle shows or hides the panels */
  constructor(
    private readonly session: Session,
    gizmo: Gizmo,
    toggle: () => void,
  ) {
    const button = (text: string, run: () => void) => {
      const made = element('button', { type: 'button' }, text);
      made.addEventListener('click', run);
      return made;
    };
    this.undo = button('Undo', () => session.history.undo());
    this.redo = button('Redo', () => session.history.redo());
    const press = (made: HTMLButtonElement, isPressed: boolean) => made.setAttribute('aria-pressed', String(isPressed));
    const gizmos = Object.entries(modes).map(([mode, label]) => {
      const made = button(label, () => {
        gizmo.mode = mode as GizmoMode;
        for (const each of gizmos) press(each, each === made);
      });
      press(made, gizmo.mode === mode);
      return made;
    });
    const space = button('Local', () => {
      gizmo.space = gizmo.space === 'local' ? 'world' : 'local';
      press(space, gizmo.space === 'local');
    });
    press(space, gizmo.space === 'local');
    const fold = button('Hide', () => {
      toggle();
      fold.setAttribute('aria-expanded', String(fold.textContent === 'Show'));
      fold.textContent = fold.textContent === 'Show' ? 'Hide' : 'Show';
    });
    fold.setAttribute('aria-expanded', 'true');
    this.element.append(this.undo, this.redo, ...gizmos, space, fold);
    this.ends = [session.history.changed.listen(() => this.show())];
    this.show();
  }

  dispose(): void {
    for (const end of this.ends) end();
  }

  private show(): void {
    const { undoLabel, redoLabel } = this.session.history;
    // not `disabled`, which would take the focus, and with it the keys, from a button that was just pressed
    this.undo.ariaDisabled = String(undoLabel === null);
    this.undo.title = undoLabel === null ? '' : `Undo ${undoLabel}`;
    this.redo.ariaDisabled = String(redoLabel === null);
    this.redo.title = redoLabel === null ? '' : `Redo ${redoLabel}`;
  }
}
