import { t, type TransformMode } from '@farol/editing';
import type { Session } from '../model/Session';
import { duplicateSelected } from '../model/duplicateSelected';
import { removeSelected } from '../model/removeSelected';
import { icon, type IconName } from '../ui/icon';
import { element } from '../ui/element';
import type { Gizmo } from '../viewport/Gizmo';

/** Keys of the gizmo while the focus is in the panels, as in Farol's own editor. */
const modeKeys: Readonly<Record<string, TransformMode>> = { w: 'translate', e: 'rotate', r: 'scale' };

/**
 * Action of the gizmo for a key; null for other keys.
 * @param key - in lower case
 */
export function gizmoKey(gizmo: Gizmo, key: string): (() => void) | null {
  const mode = modeKeys[key];
  if (mode) return () => (gizmo.mode = mode);
  return key === 'x' ? () => (gizmo.space = gizmo.space === 'local' ? 'world' : 'local') : null;
}

const keyOf = (mode: TransformMode): string =>
  Object.keys(modeKeys)
    .find((key) => modeKeys[key] === mode)!
    .toUpperCase();

const modes = (): Record<TransformMode, string> => ({
  translate: t('Move'),
  rotate: t('Rotate'),
  scale: t('Scale##verb'),
});

/** Toolbar: undo and redo, transform modes, duplicate, delete and close. */
export class Bar {
  readonly element = element('div', { className: 'bar', role: 'toolbar', 'aria-label': t('Editor') });
  private readonly undo: HTMLButtonElement;
  private readonly redo: HTMLButtonElement;
  private readonly duplicate: HTMLButtonElement;
  private readonly remove: HTMLButtonElement;
  private readonly gizmos: ReadonlyMap<TransformMode, HTMLButtonElement>;
  private readonly space: HTMLButtonElement;
  private readonly problem = element('p', { role: 'alert' });
  private readonly ends: (() => void)[];

  /** @param toggle - shows or hides the panels */
  constructor(
    private readonly session: Session,
    private readonly gizmo: Gizmo,
    toggle: () => void,
  ) {
    const button = (text: string, run: () => void) => {
      const made = element('button', { type: 'button' }, text);
      made.addEventListener('click', run);
      return made;
    };
    // texts and icons equal those of Farol's own editor
    const iconButton = (name: IconName, text: string, run: () => void) => {
      const made = button('', run);
      made.append(icon(name));
      made.className = 'icon-button';
      made.ariaLabel = made.title = text;
      return made;
    };
    this.undo = iconButton('undo', t('Undo'), () => session.commands.undo());
    this.redo = iconButton('redo', t('Redo'), () => session.commands.redo());
    this.gizmos = new Map(
      (Object.entries(modes()) as [TransformMode, string][]).map(([mode, label]) => {
        const made = iconButton(mode, label, () => (gizmo.mode = mode));
        made.title = `${label} (${keyOf(mode)})`;
        return [mode, made];
      }),
    );
    const alongOwn = t("Handles along the object's axes, not the world's");
    this.space = iconButton('local', alongOwn, gizmoKey(gizmo, 'x')!);
    this.space.title = `${alongOwn} (X)`;
    this.duplicate = iconButton('duplicate', t('Duplicate'), () => session.attempt(() => duplicateSelected(session)));
    this.remove = iconButton('remove', t('Delete'), () => session.attempt(() => removeSelected(session)));
    this.duplicate.title = `${t('Duplicate')} (Ctrl+D)`;
    this.remove.title = `${t('Delete')} (${t('Delete##key')})`;
    const fold = button(t('Hide'), () => {
      toggle();
      const isFolded = fold.ariaExpanded === 'true';
      fold.ariaExpanded = String(!isFolded);
      fold.textContent = isFolded ? t('Show') : t('Hide');
    });
    fold.setAttribute('aria-expanded', 'true');
    this.element.append(this.undo, this.redo, this.duplicate, this.remove);
    this.element.append(...this.gizmos.values(), this.space, fold, this.problem);
    const shows = [session.commands.changed, session.selection.changed, session.problemChanged, session.edited];
    this.ends = shows.map((signal) => signal.subscribe(() => this.show()));
    this.show();
  }

  dispose(): void {
    for (const end of this.ends) end();
  }

  private show(): void {
    const { commands, topmost, problem } = this.session;
    const { undoLabel, redoLabel } = commands;
    // `disabled` would take the focus off a button that was just pressed, and with it the hot keys
    this.undo.ariaDisabled = String(undoLabel === null);
    this.undo.title = undoLabel === null ? t('Undo') : t('Undo: {edit}', { edit: undoLabel });
    this.redo.ariaDisabled = String(redoLabel === null);
    this.redo.title = redoLabel === null ? t('Redo') : t('Redo: {edit}', { edit: redoLabel });
    for (const [mode, each] of this.gizmos) each.setAttribute('aria-pressed', String(this.gizmo.mode === mode));
    this.space.setAttribute('aria-pressed', String(this.gizmo.space === 'local'));
    for (const each of [this.duplicate, this.remove]) each.ariaDisabled = String(topmost.length === 0);
    this.problem.hidden = problem === '';
    this.problem.textContent = problem;
  }
}
