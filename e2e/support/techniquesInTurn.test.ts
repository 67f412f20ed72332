import { afterEach, describe, expect, it, vi } from 'vitest';
import { techniquesInTurn } from './techniquesInTurn';

const names = Array.from({ length: 11 }, (_, i) => String(i));

describe('techniquesInTurn', () => {
  afterEach(() => vi.unstubAllEnvs());

  it('gives each its share', () => {
    const seen = names.flatMap((_, turn) => techniquesInTurn(names, turn, 4));
    for (const name of names) expect(seen.filter((each) => each === name)).toHaveLength(4);
    expect(new Set(techniquesInTurn(names, 2, 4)).size).toBe(4);
  });

  it('gives no more than there are, and all on request', () => {
    expect(techniquesInTurn(['a', 'b'], 1, 4)).toHaveLength(2);
    vi.stubEnv('FAROL_SWEEP', 'all');
    expect(techniquesInTurn(names, 3, 4)).toEqual(names);
  });
});
