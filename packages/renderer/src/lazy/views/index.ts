import { addMicroShaders } from '../../microshaders/addMicroShaders';
import type { MicroShaderRegistry } from '../../microshaders';
import * as chunks from './chunks';
import { OverdrawPass } from './OverdrawPass';
import { SurfaceViewPass } from './SurfaceViewPass';

/** Its chunks, by name. */
export const microShaders = { ...chunks };

/** What draws the views that no technique draws. */
export interface ViewPasses {
  readonly overdraw: OverdrawPass;
  readonly surfaceView: SurfaceViewPass;
}

/** The renderer fetches this when such a view is first asked for. */
export function makeViewPasses(registry: MicroShaderRegistry): ViewPasses {
  addMicroShaders(registry, 'views', microShaders);
  return { overdraw: new OverdrawPass(), surfaceView: new SurfaceViewPass() };
}
