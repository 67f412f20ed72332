import { afterEach, expect, it, vi } from 'vitest';
import { watchPixelRatio } from './watchPixelRatio';

afterEach(() => {
  vi.unstubAllGlobals();
});

it('tells of each change of the pixel ratio until it is ended', () => {
  let query = new EventTarget();
  const asked: string[] = [];
  vi.stubGlobal('matchMedia', (text: string) => {
    asked.push(text);
    return (query = new EventTarget());
  });
  const changed = vi.fn<() => void>();
  const moveTo = (ratio: number): void => {
    vi.stubGlobal('devicePixelRatio', ratio);
    query.dispatchEvent(new Event('change'));
  };
  vi.stubGlobal('devicePixelRatio', 1);
  const end = watchPixelRatio(changed);
  moveTo(2);
  moveTo(1.5);
  expect(changed).toHaveBeenCalledTimes(2);
  expect(asked).toEqual(['(resolution: 1dppx)', '(resolution: 2dppx)', '(resolution: 1.5dppx)']);
  end();
  moveTo(1);
  expect(changed).toHaveBeenCalledTimes(2);
});
