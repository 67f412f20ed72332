import { t } from '@farol/editing';
import { useEffect, useRef, useState } from 'preact/hooks';
import type { NormalsPicture, NormalsWay } from '../normals/NormalsPicture';
import { pictureSize, useNormalsPictures } from '../normals/useNormalsPictures';
import './NormalsFigure.css';
import { PixelCanvas } from './PixelCanvas';

const words: Readonly<Record<NormalsWay, { title: string; alt: string; text: string }>> = {
  faces: {
    title: 'By faces',
    alt: 'Arcade whose blocks and medallions look soft, like cushions',
    text: 'Each point takes the mean of all triangles that meet there, so edges are shaded as if they were round: the blocks under the gallery look like cushions, and the diagonals of triangles show as stripes. The normal leans from its triangle by more than 30° at {share} of the corners.',
  },
  crease: {
    title: 'By crease angle',
    alt: 'The same arcade, whose blocks and medallions have sharp edges',
    text: 'Only triangles that meet at less than 30° share a normal: blocks and mouldings keep their edges, and columns and arches stay round. It leans by more at {share} of the corners.',
  },
};

interface NormalsFigureProps {
  /** Whether a run is in progress: the pictures wait. */
  isMeasuring: boolean;
}

/** Figure 4.3 of the thesis: a mesh with normals computed in two ways. Drawn when it is scrolled to. */
export function NormalsFigure({ isMeasuring }: NormalsFigureProps) {
  const pair = useRef<HTMLDivElement>(null);
  const [isSeen, setSeen] = useState(false);
  useEffect(() => {
    const look = (entries: readonly IntersectionObserverEntry[]): void => {
      if (entries.some(({ isIntersecting }) => isIntersecting)) setSeen(true);
    };
    const observer = new IntersectionObserver(look, { threshold: 0.25 });
    if (pair.current) observer.observe(pair.current);
    return () => observer.disconnect();
  }, []);
  const { pictures, problem } = useNormalsPictures(isSeen && !isMeasuring);
  return (
    <section class="normals" aria-labelledby="normals-title">
      <h2 id="normals-title">{t('Normals that a file lacks')}</h2>
      <p>
        {t(
          'Sponza, as it was handed round in 2015, came without normals; figure 4.3 of the thesis that Farol grew from shows what computed ones did to its arches. Here the atrium’s normals are taken off and computed again in two ways, under 50 lights, on your machine.',
        )}
      </p>
      {problem && (
        <p class="problem" role="alert">
          {problem}
        </p>
      )}
      {!problem && (
        <div class="pair" ref={pair}>
          <Picture way="faces" drawn={pictures.faces} />
          <Picture way="crease" drawn={pictures.crease} />
        </div>
      )}
    </section>
  );
}

function Picture({ way, drawn }: { way: NormalsWay; drawn: NormalsPicture | undefined }) {
  const { title, alt, text } = words[way];
  return (
    <figure>
      <PixelCanvas pixels={drawn?.picture ?? null} label={drawn ? t(alt) : t('Not drawn yet')} {...pictureSize} />
      <figcaption>
        <strong>{t(title)}.</strong> {drawn ? t(text, { share: percent(drawn.leaning) }) : t('Drawing …')}
      </figcaption>
    </figure>
  );
}

function percent(share: number): string {
  if (share === 0) return t('none##of the corners');
  return share < 0.005 ? t('less than 1%') : `${Math.round(share * 100)}%`;
}
