import { formatNumber, SetFields, t, toDegrees, toRadians } from '@farol/editing';
import { type Component, SunAndMoon } from '@farol/engine';
import { type KeyboardEvent, type MouseEvent, type ReactNode, useState } from 'react';
import { ownersName } from '../../../model/ownersName';
import { useEditor, useSignal } from '../../../ui/EditorContext';
import { useOwnersRevision } from '../../../ui/useOwnersRevision';
import { coasts } from './coasts';
import './sun.css';

const pathOf = (corners: readonly number[]): string => {
  let path = '';
  for (let i = 0; i < corners.length; i += 2) path += `${i ? 'L' : 'M'}${corners[i]} ${-corners[i + 1]}`;
  return `${path}Z`;
};

const land = coasts.map(pathOf).join('');
const degrees = (angle: number): string => `${formatNumber(Math.round(toDegrees(angle) * 10) / 10, 'short')}°`;

const steps: Readonly<Record<string, readonly [number, number]>> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, 1],
  ArrowDown: [0, -1],
};

/** World map to choose the place on, and the positions of sun and moon. @param props.components - SunAndMoons */
export function SunBar({ components }: { components: readonly Component[] }): ReactNode {
  const { commands, document } = useEditor();
  useOwnersRevision(components);
  useSignal(document.previewed);
  const [owners] = useState(() => components.filter((each) => each instanceof SunAndMoon));
  const [first] = owners;
  const put = (longitude: number, latitude: number): void => {
    const name = ownersName(owners);
    const values = {
      longitude: toRadians(Math.min(180, Math.max(-180, longitude))),
      latitude: toRadians(Math.min(90, Math.max(-90, latitude))),
      timeZone: Math.min(14, Math.max(-12, Math.round(longitude / 15))),
    };
    const edits = owners.flatMap((owner) =>
      Object.entries(values).map(([field, value]) => ({ owner, name: field, value })),
    );
    commands.run(new SetFields(t('Set place of {name}', { name }), edits));
  };
  const click = (event: MouseEvent<SVGSVGElement>): void => {
    const { left, top, width, height } = event.currentTarget.getBoundingClientRect();
    const longitude = ((event.clientX - left) / width) * 360 - 180;
    const latitude = 90 - ((event.clientY - top) / height) * 180;
    put(Math.round(longitude * 10) / 10, Math.round(latitude * 10) / 10);
  };
  const key = (event: KeyboardEvent): void => {
    const step = steps[event.key];
    if (!step) return;
    event.preventDefault();
    event.stopPropagation();
    const by = event.shiftKey ? 10 : 1;
    put(toDegrees(first.longitude) + step[0] * by, toDegrees(first.latitude) + step[1] * by);
  };
  const { sun, moon } = first;
  const [x, y] = [toDegrees(first.longitude), -toDegrees(first.latitude)];
  return (
    <figure className="sun-bar">
      <svg
        viewBox="-180 -90 360 180"
        role="application"
        tabIndex={0}
        aria-label={t('Map of the world: click to set the place, arrow keys move it')}
        onClick={click}
        onKeyDown={key}
      >
        <path className="map-land" d={land} />
        <path className="map-lines" d="M-180 0H180M0 -90V90" />
        <circle className="map-place" cx={x} cy={y} r={5} />
      </svg>
      <figcaption>
        {t('Sun {elevation} high, at {azimuth}', { elevation: degrees(sun.elevation), azimuth: degrees(sun.azimuth) })}
        <br />
        {t('Moon {elevation} high, {lit} % lit', {
          elevation: degrees(moon.elevation),
          lit: Math.round(moon.lit * 100),
        })}
      </figcaption>
    </figure>
  );
}
