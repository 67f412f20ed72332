import * as gbuffer from '../gbuffer/chunks';
import * as gpu from '../gpu/chunks';
import * as lighting from '../lighting/chunks';
import * as loops from '../lighting/loops/chunks';
import * as shading from '../lighting/shading/chunks';
import * as volumes from '../techniques/light-volumes/chunks';
import * as output from '../passes/output/chunks';

/** Sources of the microshaders in the core, by name. A new microshader is a file, and a line in its folder's `chunks.ts`. */
export const coreSources = { ...gbuffer, ...gpu, ...lighting, ...loops, ...shading, ...volumes, ...output };
