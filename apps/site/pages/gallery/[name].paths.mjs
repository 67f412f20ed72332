import { galleryPages } from '@farol/tools/site/galleryPages';

/** A page for each example of the gallery. */
export default { watch: ['../../live/gallery/*'], paths: () => galleryPages('en') };
