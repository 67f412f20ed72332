import { t } from '@farol/editing';
import { type AttachLanguage, languages } from '../language/languages';
import type { Drawing } from '../model/Drawing';
import type { Session } from '../model/Session';
import { element } from '../ui/element';
import type { Gizmo } from '../viewport/Gizmo';
import type { RenderHook } from '../viewport/RenderHook';
import { Bar } from './Bar';
import { FramePanel } from './FramePanel';
import { Inspector } from './Inspector';
import { Tree } from './Tree';

/** Parts of the attached editor that the panels show and change. */
export interface PanelsOptions {
  readonly session: Session;
  readonly gizmo: Gizmo;
  readonly hook: RenderHook;
  readonly drawing: Drawing;
  readonly language: AttachLanguage;
  /** Called when the user has chosen another language. */
  onLanguage(language: AttachLanguage): void;
}

/** Bar, tree, inspector and frame panel, in the language at the time of their creation. */
export class Panels {
  readonly element: HTMLElement;
  readonly inspector: Inspector;
  readonly language = element('select', { 'aria-label': t('Language'), title: t('Language') });
  private readonly tree: Tree;
  private readonly frame: FramePanel;
  private readonly bar: Bar;
  private readonly body: HTMLElement;

  constructor({ session, gizmo, hook, drawing, language, onLanguage }: PanelsOptions) {
    this.tree = new Tree(session);
    this.inspector = new Inspector(session);
    this.frame = new FramePanel(session, hook, drawing);
    const { tree, inspector, frame } = this;
    this.body = element('div', { className: 'panels' }, tree.search, tree.element, inspector.element, frame.element);
    this.bar = new Bar(session, gizmo, () => (this.body.hidden = !this.body.hidden));
    const choice = this.language;
    choice.append(...Object.entries(languages).map(([name, label]) => new Option(label, name)));
    choice.value = language;
    choice.addEventListener('change', () => onLanguage(choice.value as AttachLanguage));
    this.bar.element.append(choice);
    this.element = element(
      'section',
      { className: 'editor', lang: language, 'aria-label': t('Farol editor') },
      this.bar.element,
      this.body,
    );
  }

  /** Updates the shown values; call a few times a second. */
  refresh(): void {
    if (this.body.hidden) return;
    this.tree.refresh();
    this.inspector.refresh();
    this.frame.refresh();
  }

  dispose(): void {
    for (const part of [this.bar, this.frame, this.inspector, this.tree]) part.dispose();
    this.element.remove();
  }
}
