/** Park and Miller's generator: the same numbers for the same seed. */
export function random(seed: number): () => number {
  return () => {
    seed = (seed * 16807) % 2147483647;
    return (seed - 1) / 2147483646;
  };
}
