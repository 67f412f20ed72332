import type { Lazy } from '../../frame/Lazy';
import type { MicroShaderRegistry } from '../../microshaders';
import { addMicroShaders } from '../../microshaders/addMicroShaders';

/** Fetches pieces of late code, and adds their microshaders to the registry. */
export async function addLazyMicroShaders(
  microshaders: MicroShaderRegistry,
  parts: readonly Lazy<object>[],
): Promise<void> {
  const codes: readonly { readonly microShaders?: Readonly<Record<string, string>> }[] = await Promise.all(
    parts.map((part) => part.load()),
  );
  codes.forEach((code, i) => {
    if (code.microShaders) addMicroShaders(microshaders, parts[i].name, code.microShaders);
  });
}
