import type { ViewPasses } from '../views';
import { isTechniqueView, type View } from '../frame/views';
import type { MicroShaderRegistry } from '../microshaders';
import { viewCode } from './lazyCode';

/** Fetches and holds the passes of views that no technique draws. */
export class LazyViews {
  /** Passes of the views that techniques do not draw; null until their code is loaded. */
  passes: ViewPasses | null = null;

  constructor(private readonly microshaders: MicroShaderRegistry) {}

  /** @returns the view to draw: the one asked for, or the final picture while its code is not loaded */
  available(view: View): View {
    if (isTechniqueView(view)) return view;
    this.passes ??= viewCode.use(({ makeViewPasses }) => makeViewPasses(this.microshaders));
    return this.passes === null ? 'final' : view;
  }

  /** Bytes of the views' targets. */
  get bytes(): number {
    return this.passes?.bytes ?? 0;
  }

  dispose(): void {
    this.passes?.dispose();
  }
}
