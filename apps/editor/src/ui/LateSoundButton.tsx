import { lazy, type ReactNode, Suspense } from 'react';

const SoundButton = lazy(async () => ({ default: (await import('./SoundButton')).SoundButton }));

/** A `SoundButton` whose code comes once there is a sound to see. */
export function LateSoundButton({ name }: { name: string }): ReactNode {
  return (
    <Suspense fallback={null}>
      <SoundButton name={name} />
    </Suspense>
  );
}
