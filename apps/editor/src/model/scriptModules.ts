import * as engine from '@farol/engine';
import * as fields from '@farol/engine/fields';
import * as three from 'virtual:whole-three';

/** What scripts can import besides each other. */
export const scriptModules = { three, '@farol/engine': engine, '@farol/engine/fields': fields };
