/** Park and Miller's generator: the same numbers, from 0 to 1, for the same seed. */
export function random(seed: number): () => number {
  return () => {
    seed = (seed * 16807) % 2147483647;
    return (seed - 1) / 2147483646;
  };
}

/** As `random`, in a range given with each call. */
export function randomIn(seed: number): (low: number, high: number) => number {
  const share = random(seed);
  return (low, high) => low + (high - low) * share();
}
