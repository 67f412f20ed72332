import { expect, it, vi } from 'vitest';
import { LatePart } from './LatePart';

const unexpected = (error: unknown): never => {
  throw error;
};

interface Part {
  dispose(): void;
}

const makePart = (): Part => ({ dispose: vi.fn<() => void>() });

it('is fetched once, when it is first needed', async () => {
  let isNeeded = false;
  const part = makePart();
  const load = vi.fn<() => Promise<() => Part>>(async () => () => part);
  const late = new LatePart(() => isNeeded, load, unexpected);
  expect(late.get()).toBeNull();
  expect(load).not.toHaveBeenCalled();
  isNeeded = true;
  expect(late.get()).toBeNull();
  await vi.waitFor(() => expect(late.get()).toBe(part));
  isNeeded = false;
  expect(late.get()).toBe(part);
  expect(load).toHaveBeenCalledTimes(1);
  late.dispose();
  expect(part.dispose).toHaveBeenCalledTimes(1);
});

it('is not made where its code comes after the end', async () => {
  const make = vi.fn<() => Part>(makePart);
  let fetched: (make: () => Part) => void = () => {};
  const code = new Promise<() => Part>((resolve) => (fetched = resolve));
  const late = new LatePart(
    () => true,
    () => code,
    unexpected,
  );
  late.get();
  late.dispose();
  fetched(make);
  await code;
  expect(late.get()).toBeNull();
  expect(make).not.toHaveBeenCalled();
});

it('tells once that its code cannot be fetched', async () => {
  const failed = vi.fn<(error: unknown) => void>();
  const late = new LatePart(
    () => true,
    () => Promise.reject(new Error('no network')),
    failed,
  );
  late.get();
  await vi.waitFor(() => expect(failed).toHaveBeenCalledWith(new Error('no network')));
  late.get();
  expect(failed).toHaveBeenCalledTimes(1);
});
