import { type ComponentType, type ReactNode, useEffect, useState } from 'react';

type Curve = ComponentType<{ name: string }>;

/** A `PolarCurve` whose code comes once there is a profile to see. */
export function LatePolarCurve({ name }: { name: string }): ReactNode {
  const [PolarCurve, setCurve] = useState<Curve | null>(null);
  useEffect(() => {
    let isShown = true;
    void import('./PolarCurve').then(
      ({ PolarCurve: loaded }) => {
        if (isShown) setCurve(() => loaded);
      },
      // without the connection there is no curve; the next light with a profile asks again
      () => {},
    );
    return () => {
      isShown = false;
    };
  }, []);
  return PolarCurve && <PolarCurve name={name} />;
}
