import { type ComponentType, createElement, type ReactNode, useEffect, useState } from 'react';

/**
 * A component whose code is fetched when it is first shown. When fetching fails, the placeholder stays; the next time
 * that the component is shown, fetching is tried again.
 * @param load - fetches the component
 * @param placeholder - shown until then; nothing by default
 */
export function lateComponent<Props extends object>(
  load: () => Promise<ComponentType<Props>>,
  placeholder: (props: Props) => ReactNode = () => null,
): (props: Props) => ReactNode {
  let component: ComponentType<Props> | null = null;
  return function LateComponent(props) {
    const [shown, setShown] = useState(() => component);
    useEffect(() => {
      let isMounted = true;
      if (!shown) {
        (component ? Promise.resolve(component) : load()).then(
          (loaded) => {
            component = loaded;
            if (isMounted) setShown(() => loaded);
          },
          () => {},
        );
      }
      return () => {
        isMounted = false;
      };
    }, [shown]);
    return shown ? createElement(shown, props) : placeholder(props);
  };
}
