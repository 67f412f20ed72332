import type { CollectOptions } from '../scene/collectMeshes';

/** Options that bake everything, and the collected warnings. */
export function testOptions(): CollectOptions & { warnings: string[] } {
  const warnings: string[] = [];
  return {
    warnings,
    isStatic: () => true,
    throwsShadow: () => true,
    onWarning: (sentence) => warnings.push(sentence),
  };
}
