import { Signal } from '@farol/editing';
import type { FarolRenderer, TechniqueName } from '@farol/renderer';
import type { RenderHook } from '../viewport/RenderHook';
import type { Session } from './Session';

/** Name of a Farol technique, or 'three' for three's own renderer. */
export type Drawer = TechniqueName | 'three';

type Renderer = typeof import('@farol/renderer');

/** Switches the page between Farol and three. Farol's code is fetched on first use. */
export class Drawing {
  /** Emits when the page changes between Farol and three, or to another technique. */
  readonly changed = new Signal();
  /** Farol's module, with the names of techniques and views; null until loaded. */
  module: Renderer | null = null;
  private own: FarolRenderer | null = null;
  private isDisposed = false;

  /** @param given - the page's own FarolRenderer, if it has one; then three's own renderer cannot be chosen */
  constructor(
    private readonly session: Session,
    private readonly hook: RenderHook,
    readonly given: FarolRenderer | null,
  ) {
    if (given) void this.load();
  }

  /** Renderer that draws the page at present; null while three draws. */
  get farol(): FarolRenderer | null {
    return this.given ?? this.hook.farol;
  }

  get drawer(): Drawer {
    return this.farol?.technique ?? 'three';
  }

  async load(): Promise<Renderer> {
    this.module ??= await import('@farol/renderer');
    this.changed.emit();
    return this.module;
  }

  /**
   * @throws Error (as a rejection) for an unknown technique, or one that the device cannot run; the previous one
   * continues
   */
  async choose(drawer: Drawer): Promise<void> {
    const { session, hook, given } = this;
    if (drawer === 'three') {
      if (given)
        throw new Error('attachEditor: this page draws by its own FarolRenderer; choose one of its techniques.');
      hook.farol = null;
    } else {
      const { FarolRenderer } = await this.load();
      if (this.isDisposed) return;
      const farol = given ?? (this.own ??= new FarolRenderer(session.webgl));
      farol.technique = drawer;
      if (!given) hook.farol = farol;
    }
    this.changed.emit();
    session.edited.emit();
  }

  dispose(): void {
    this.isDisposed = true;
    this.hook.farol = null;
    this.own?.dispose();
  }
}
