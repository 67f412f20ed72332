import type { Lazy } from '../../frame/Lazy';
import type { MicroShaderRegistry } from '../../microshaders';
import { addMicroShaders } from '../../microshaders/addMicroShaders';

/** Fetches parts of the code, and adds the microshaders of those that have some. */
export async function addLazyMicroShaders(
  microshaders: MicroShaderRegistry,
  parts: readonly Lazy<object>[],
): Promise<void> {
  for (const part of parts) {
    const code: { readonly microShaders?: Readonly<Record<string, string>> } = await part.load();
    if (code.microShaders) addMicroShaders(microshaders, part.name, code.microShaders);
  }
}
