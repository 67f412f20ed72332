import { FileLoader, Loader } from 'three';
import { parseIES, tiltFileOf } from './parseIES';
import { PhotometricProfile } from './PhotometricProfile';

/**
 * Loads photometric files (.ies) of the LM-63 standard, of any edition from 1986 to 2019, of types A, B and C. A file named by
 * `TILT=` is loaded from the same folder.
 */
export class IESLoader extends Loader<PhotometricProfile> {
  /** Tilt of the luminaire from the position in which it was measured (degrees), for files with a tilt table. */
  tilt = 0;

  override load(
    url: string,
    onLoad: (profile: PhotometricProfile) => void,
    onProgress?: (event: ProgressEvent) => void,
    onError?: (error: unknown) => void,
  ): void {
    const { manager } = this;
    const loader = new FileLoader(manager);
    loader.setPath(this.path);
    loader.setRequestHeader(this.requestHeader);
    loader.setWithCredentials(this.withCredentials);
    loader.load(
      url,
      (text) => {
        const tell = (tilt: string | null): void => {
          let profile: PhotometricProfile;
          try {
            profile = this.parse(text as string, tilt);
          } catch (error) {
            if (onError === undefined) console.error(`IESLoader: ${url}: ${String(error)}`);
            else onError(error);
            manager.itemError(url);
            return;
          }
          onLoad(profile);
        };
        const beside = tiltFileOf(text as string);
        if (beside === null) tell(null);
        else {
          // only from the same folder: ignores any path in the file
          const name = encodeURIComponent(
            beside.slice(Math.max(beside.lastIndexOf('/'), beside.lastIndexOf('\\')) + 1),
          );
          const folder = url.slice(0, url.split(/[?#]/)[0].lastIndexOf('/') + 1);
          loader.load(
            `${folder}${name}`,
            (tilt) => tell(tilt as string),
            undefined,
            // a missing TILT file is null; the error of the parser names it
            () => tell(null),
          );
        }
      },
      onProgress,
      onError,
    );
  }

  /**
   * @param text - text of the file
   * @param tilt - text of the file named by `TILT=`; null for none
   * @throws IESError with the wrong line, and what to write there
   */
  parse(text: string, tilt: string | null = null): PhotometricProfile {
    return new PhotometricProfile(parseIES(text, { tilt }), this.tilt);
  }
}
