import * as gbuffer from '../gbuffer/chunks';
import * as gpu from '../gpu/chunks';
import * as lighting from '../lighting/chunks';
import * as loops from '../lighting/loops/chunks';
import * as shading from '../lighting/shading/chunks';
import * as volumes from '../techniques/light-volumes/chunks';
import * as output from '../passes/output/chunks';

/** Sources by name that are there from the start: a new microshader is a file, and a line in the `chunks.ts` of its folder. */
export const coreSources = { ...gbuffer, ...gpu, ...lighting, ...loops, ...shading, ...volumes, ...output };
