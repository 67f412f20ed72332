import type { CommandStack } from '@farol/editing';
import type { FarolRenderer } from '@farol/renderer';
import type { Camera, Object3D, WebGLRenderer } from 'three';
import type { AttachOptions } from './AttachOptions';
import { type Drawer, Drawing } from './model/Drawing';
import { type AttachLanguage, browserLanguage, speak } from './language/languages';
import { Session } from './model/Session';
import { actOfKey } from './panels/actOfKey';
import { Panels } from './panels/Panels';
import style from './style.css?inline';
import { element } from './ui/element';
import { drawOver } from './viewport/drawOver';
import { Gizmo } from './viewport/Gizmo';
import { Pointer } from './viewport/Pointer';
import { RenderHook } from './viewport/RenderHook';
import { SelectionBox } from './viewport/SelectionBox';

/** Interval at which values and figures of panels are refreshed (ms). */
const REFRESH = 200;

const attached = new WeakSet<WebGLRenderer>();

/** An editor over a running page, as made by `attachEditor`. */
export class AttachedEditor {
  /** The editor's only element in the page; the panels are in its shadow root, isolated from the page's styles. */
  readonly element: HTMLElement;
  private readonly root: ShadowRoot;
  private readonly session: Session;
  private readonly hook: RenderHook;
  private readonly drawing: Drawing;
  private readonly gizmo: Gizmo;
  private panels: Panels;
  private shown: AttachLanguage = 'en';
  private readonly parts: { dispose(): void }[];
  private readonly timer: number;
  private isDisposed = false;

  constructor(
    scene: Object3D,
    camera: Camera,
    private readonly webgl: WebGLRenderer,
    private readonly options: AttachOptions,
  ) {
    if (!(webgl as { isWebGLRenderer?: boolean }).isWebGLRenderer) {
      throw new Error('attachEditor: the renderer is not a WebGLRenderer; give one (WebGPURenderer is not supported).');
    }
    if (attached.has(webgl))
      throw new Error('attachEditor: this renderer has an editor already; dispose that one first.');
    attached.add(webgl);
    const session = new Session(scene, camera, webgl);
    const gizmo = new Gizmo(session);
    const box = new SelectionBox(session, gizmo.scene);
    const hook = new RenderHook(session, (render) => {
      if (!gizmo.update() && session.selection.primary === null) return;
      box.update();
      drawOver(session, render, gizmo.scene);
    });
    const drawing = new Drawing(session, hook, options.farol ?? null);
    const pointer = new Pointer(session, gizmo, options.domElement ?? webgl.domElement);
    this.element = element('div', { className: 'farol-attach' });
    this.root = this.element.attachShadow({ mode: 'open' });
    const sheet = new CSSStyleSheet();
    sheet.replaceSync(style);
    this.root.adoptedStyleSheets = [sheet];
    this.session = session;
    this.hook = hook;
    this.drawing = drawing;
    this.gizmo = gizmo;
    this.panels = this.makePanels(options.language ?? browserLanguage());
    this.parts = [pointer, drawing, box, gizmo, hook];
    session.selection.changed.subscribe(() => this.redraw());
    session.edited.subscribe(() => {
      this.panels.inspector.refresh();
      this.redraw();
    });
    (options.container ?? document.body).append(this.element);
    this.panels.refresh();
    this.timer = setInterval(() => this.panels.refresh(), REFRESH) as unknown as number;
  }

  /** The object selected last, or null; setting it selects that object alone. */
  get selected(): Object3D | null {
    return this.session.selection.primary;
  }

  set selected(object: Object3D | null) {
    this.session.select(object);
  }

  /** The selected objects, in order of selection. */
  get selection(): readonly Object3D[] {
    return this.session.selection.items;
  }

  set selection(objects: readonly Object3D[]) {
    this.session.selection.set(objects);
  }

  /** The camera that the page renders with. */
  get camera(): Camera {
    return this.session.camera;
  }

  set camera(camera: Camera) {
    this.session.camera = camera;
  }

  /** The history of edits: `undo()`, `redo()`, their labels, and `changed`, a signal. */
  get commands(): CommandStack<Object3D> {
    return this.session.commands;
  }

  /** Language of the panels. Setting it makes the panels again; it also applies to editors attached later. */
  get language(): AttachLanguage {
    return this.shown;
  }

  set language(language: AttachLanguage) {
    if (language === this.shown || this.isDisposed) return;
    this.panels.dispose();
    this.panels = this.makePanels(language);
    this.panels.refresh();
  }

  /** The FarolRenderer that draws the page; null while three's own renderer does. */
  get farol(): FarolRenderer | null {
    return this.drawing.farol;
  }

  /**
   * Switches the page to a technique of Farol's, or back to three's renderer, from the next frame on.
   * @throws Error (as a rejection) for an unknown technique, or one that the device cannot run; the previous renderer
   *   continues
   */
  drawWith(drawer: Drawer): Promise<void> {
    return this.drawing.choose(drawer);
  }

  /** Closes the editor and restores the page; edits of the scene stay. */
  dispose(): void {
    if (this.isDisposed) return;
    this.isDisposed = true;
    clearInterval(this.timer);
    for (const part of [this.panels, ...this.parts]) part.dispose();
    this.element.remove();
    attached.delete(this.webgl);
    if (this.options.onChange) this.options.onChange();
    else if (this.hook.isIdle) this.webgl.render(this.session.scene, this.session.camera);
  }

  /** Makes the panels in a language, and adds them to the page. */
  private makePanels(language: AttachLanguage): Panels {
    speak(language);
    this.shown = language;
    const { session, gizmo, hook, drawing } = this;
    const panels = new Panels({
      ...{ session, gizmo, hook, drawing, language },
      onLanguage: (chosen) => {
        this.language = chosen;
        this.panels.language.focus();
      },
    });
    panels.element.addEventListener('keydown', (event) => this.key(event));
    this.root.append(panels.element);
    return panels;
  }

  /** Handles keys pressed in the panels; the page does not get them. */
  private key(event: KeyboardEvent): void {
    event.stopPropagation();
    const act = actOfKey(this.session, this.gizmo, event);
    if (!act) return;
    event.preventDefault();
    this.session.attempt(act);
  }

  /** Requests a frame from the page. */
  private redraw(): void {
    const { options, hook, webgl, session } = this;
    if (options.onChange) {
      options.onChange();
      return;
    }
    const { frames } = hook;
    requestAnimationFrame(() =>
      requestAnimationFrame(() => {
        if (hook.frames === frames && !this.isDisposed) webgl.render(session.scene, session.camera);
      }),
    );
  }
}
