import { lazyCode } from '../../frame/lazyCode';
import type { MicroShaderRegistry } from '../../microshaders';
import { addMicroShaders } from '../../microshaders/addMicroShaders';

/** Fetches all parts of the code, and adds the microshaders of those that have some. */
export async function addLazyMicroShaders(microshaders: MicroShaderRegistry): Promise<void> {
  for (const part of lazyCode) {
    const code = await part.load();
    if ('microShaders' in code) addMicroShaders(microshaders, part.name, code.microShaders);
  }
}
