import { addMicroShaders } from '../microshaders/addMicroShaders';
import type { MicroShaderRegistry } from '../microshaders';
import countView from './countView.glsl?raw';
import { OverdrawPass } from './OverdrawPass';
import surfaceView from './surfaceView.glsl?raw';
import { SurfaceViewPass } from './SurfaceViewPass';

/** What draws the views that no technique draws. */
export interface ViewPasses {
  readonly overdraw: OverdrawPass;
  readonly surfaceView: SurfaceViewPass;
}

/** The renderer fetches this when such a view is first asked for. */
export function makeViewPasses(microshaders: MicroShaderRegistry): ViewPasses {
  addMicroShaders(microshaders, { countView, surfaceView });
  return { overdraw: new OverdrawPass(), surfaceView: new SurfaceViewPass() };
}
