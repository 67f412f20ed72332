import * as engine from '@farol/engine';
import * as fields from '@farol/engine/fields';
import * as offered from './threeForScripts';

/** A name that scripts cannot have is told, in place of `undefined`. */
const three = new Proxy(offered as unknown as Record<string, unknown>, {
  get(names, name) {
    if (typeof name !== 'string' || name in names || name === 'default' || name === 'then')
      return Reflect.get(names, name);
    throw new Error(`Scripts cannot have three's ${name} here: make it of what 'three' offers to scripts.`);
  },
});

/** What scripts can import besides each other. */
export const scriptModules = { three, '@farol/engine': engine, '@farol/engine/fields': fields };
