import { lazy, type ReactNode, Suspense } from 'react';

const SoundButton = lazy(async () => ({ default: (await import('./SoundButton')).SoundButton }));

/** A `SoundButton` whose code is fetched when first needed. */
export function LateSoundButton({ name }: { name: string }): ReactNode {
  return (
    <Suspense fallback={null}>
      <SoundButton name={name} />
    </Suspense>
  );
}
