import { type ComponentType, type ReactNode, useEffect, useState } from 'react';

type Curve = ComponentType<{ name: string }>;

/** A `PolarCurve` whose code is fetched when first needed. */
export function LatePolarCurve({ name }: { name: string }): ReactNode {
  const [PolarCurve, setCurve] = useState<Curve | null>(null);
  useEffect(() => {
    let isShown = true;
    void import('./PolarCurve').then(
      ({ PolarCurve: loaded }) => {
        if (isShown) setCurve(() => loaded);
      },
      // offline there is no curve; the next light with a profile tries again
      () => {},
    );
    return () => {
      isShown = false;
    };
  }, []);
  return PolarCurve && <PolarCurve name={name} />;
}
