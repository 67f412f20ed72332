import type { CollectOptions } from '../scene/collectMeshes';

/** Options under which everything is baked, and the sentences that were told. */
export function testOptions(): CollectOptions & { warnings: string[] } {
  const warnings: string[] = [];
  return {
    warnings,
    isStatic: () => true,
    throwsShadow: () => true,
    onWarning: (sentence) => warnings.push(sentence),
  };
}
