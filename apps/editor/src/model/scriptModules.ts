import * as engine from 'virtual:whole-engine';
import * as fields from 'virtual:whole-engine-fields';
import * as three from 'virtual:whole-three';

/** Modules that scripts can import, besides other scripts. */
export const scriptModules = { three, '@farol/engine': engine, '@farol/engine/fields': fields };
