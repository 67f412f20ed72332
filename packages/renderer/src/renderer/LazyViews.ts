import type { ViewPasses } from '../views';
import { isBufferView, isTechniqueView, type View } from '../frame/views';
import type { MicroShaderRegistry } from '../microshaders';
import { viewCode } from './lazyCode';

/** Fetches and holds the passes of views that no technique draws. */
export class LazyViews {
  /** Passes of the views that techniques do not draw; null until their code is loaded. */
  passes: ViewPasses | null = null;
  /** View of a buffer, drawn over the final picture; null for none. */
  buffer: View | null = null;

  constructor(private readonly microshaders: MicroShaderRegistry) {}

  /** @returns the view to draw: `view`, or 'final' if `view` shows a buffer over that picture, or its code is not loaded */
  available(view: View): View {
    this.buffer = null;
    if (isTechniqueView(view)) return view;
    this.passes ??= viewCode.use(({ makeViewPasses }) => makeViewPasses(this.microshaders));
    if (this.passes === null || !isBufferView(view)) return this.passes === null ? 'final' : view;
    this.buffer = view;
    return 'final';
  }

  /** Bytes of the views' targets. */
  get bytes(): number {
    return this.passes?.bytes ?? 0;
  }

  dispose(): void {
    this.passes?.dispose();
  }
}
