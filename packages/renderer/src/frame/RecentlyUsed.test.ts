import { afterEach, beforeEach, expect, it, vi } from 'vitest';
import { RecentlyUsed } from './RecentlyUsed';

beforeEach(() => vi.useFakeTimers());
afterEach(() => vi.useRealTimers());

const begin = () => {
  const released: string[] = [];
  return { released, recent: new RecentlyUsed<string>((key) => released.push(key)) };
};

it('releases what others are used in place of after a while, without further uses', () => {
  const { released, recent } = begin();
  recent.use('first');
  recent.use('second');
  vi.advanceTimersByTime(1900);
  expect(released).toEqual([]);
  vi.advanceTimersByTime(4000);
  expect(released).toEqual(['first']);
  vi.advanceTimersByTime(60_000);
  expect(released, 'the last is kept').toEqual(['first']);
  expect(vi.getTimerCount()).toBe(0);
});

it('keeps two that take turns, however long', () => {
  const { released, recent } = begin();
  for (let frame = 0; frame < 1000; frame++) {
    recent.use(frame % 2 ? 'odd' : 'even');
    vi.advanceTimersByTime(16);
  }
  expect(released).toEqual([]);
});

it('keeps few of many at once', () => {
  const { released, recent } = begin();
  for (let i = 0; i < 10; i++) recent.use(String(i));
  expect(released).toEqual(['0', '1', '2', '3', '4', '5']);
  recent.use('7');
  expect(released, 'a use again').toHaveLength(6);
});

it('forgets all without a release', () => {
  const { released, recent } = begin();
  recent.use('first');
  recent.use('second');
  recent.clear();
  vi.advanceTimersByTime(60_000);
  expect(released).toEqual([]);
});
