import type { ViewPasses } from '../views';
import { isTechniqueView, type View } from '../frame/views';
import type { MicroShaderRegistry } from '../microshaders';
import { viewCode } from './lazyCode';

/** Draws the views that no technique draws, once such a view was asked for and its code is there. */
export class LazyViews {
  /** Null until then. */
  passes: ViewPasses | null = null;

  constructor(private readonly microshaders: MicroShaderRegistry) {}

  /** @returns the view to draw for the one asked for: the final picture while its code is not there */
  available(view: View): View {
    if (isTechniqueView(view)) return view;
    this.passes ??= viewCode.use(({ makeViewPasses }) => makeViewPasses(this.microshaders));
    return this.passes === null ? 'final' : view;
  }

  /** Bytes of the targets. */
  get bytes(): number {
    return this.passes?.bytes ?? 0;
  }

  dispose(): void {
    this.passes?.dispose();
  }
}
