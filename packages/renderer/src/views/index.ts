import { addMicroShaders } from '../microshaders/addMicroShaders';
import type { MicroShaderRegistry } from '../microshaders';
import { BufferViews } from './buffers/BufferViews';
import * as chunks from './chunks';
import { OverdrawPass } from './OverdrawPass';
import { SurfaceViewPass } from './SurfaceViewPass';

export const microShaders = { ...chunks };

/** Passes of the views that no technique draws. */
export interface ViewPasses {
  readonly overdraw: OverdrawPass;
  readonly surfaceView: SurfaceViewPass;
  readonly buffers: BufferViews;
  /** Bytes of the targets. */
  readonly bytes: number;
  dispose(): void;
}

/** Makes the passes of views; late code. */
export function makeViewPasses(registry: MicroShaderRegistry): ViewPasses {
  addMicroShaders(registry, 'views', microShaders);
  const overdraw = new OverdrawPass();
  const surfaceView = new SurfaceViewPass();
  const buffers = new BufferViews(surfaceView);
  return {
    overdraw,
    surfaceView,
    buffers,
    get bytes() {
      return overdraw.bytes + surfaceView.bytes;
    },
    dispose() {
      overdraw.dispose();
      surfaceView.dispose();
      buffers.dispose();
    },
  };
}
