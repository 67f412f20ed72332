import * as engine from '@farol/engine';
import * as fields from '@farol/engine/fields';
import * as three from 'virtual:whole-three';

/** Modules that scripts can import, besides other scripts. */
export const scriptModules = { three, '@farol/engine': engine, '@farol/engine/fields': fields };
