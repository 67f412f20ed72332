import emitters from '../trace/emitters.glsl?raw';
import sampleCount from '../lightmap/sampleCount.glsl?raw';
import lightTable from '../trace/lightTable.glsl?raw';
import random from '../trace/random.glsl?raw';
import sky from '../trace/sky.glsl?raw';
import tables from '../trace/tables.glsl?raw';
import traverse from '../trace/traverse.glsl?raw';

/** The shader texts that others include, by name. */
export const chunks = { emitters, lightTable, random, sampleCount, sky, tables, traverse };
