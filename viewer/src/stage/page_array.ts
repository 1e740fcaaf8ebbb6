// Pictures of one size as the layers of one texture, filled one after another.
import { ExternalTexture, type Texture, type WebGLRenderer } from "three";

export class PageArray {
  readonly texture: Texture;
  private readonly gl: WebGL2RenderingContext;
  private readonly handle: WebGLTexture;
  private readonly levels: number;

  constructor(
    private readonly renderer: WebGLRenderer,
    readonly width: number,
    readonly height: number,
    readonly layers: number,
    levels: number,
    sharpness: number,
    quick: boolean,
  ) {
    this.gl = renderer.getContext() as WebGL2RenderingContext;
    const gl = this.gl;
    this.levels = Math.min(levels, 1 + Math.floor(Math.log2(Math.max(width, height))));
    this.handle = gl.createTexture();
    this.bound(() => {
      gl.texStorage3D(gl.TEXTURE_2D_ARRAY, this.levels, gl.RGBA8, width, height, layers);
      gl.texParameteri(gl.TEXTURE_2D_ARRAY, gl.TEXTURE_MIN_FILTER, quick ? gl.LINEAR_MIPMAP_NEAREST : gl.LINEAR_MIPMAP_LINEAR);
      gl.texParameteri(gl.TEXTURE_2D_ARRAY, gl.TEXTURE_MAG_FILTER, gl.LINEAR);
      gl.texParameteri(gl.TEXTURE_2D_ARRAY, gl.TEXTURE_WRAP_S, gl.CLAMP_TO_EDGE);
      gl.texParameteri(gl.TEXTURE_2D_ARRAY, gl.TEXTURE_WRAP_T, gl.CLAMP_TO_EDGE);
      const extension = gl.getExtension("EXT_texture_filter_anisotropic");
      if (extension && sharpness > 1) gl.texParameterf(gl.TEXTURE_2D_ARRAY, extension.TEXTURE_MAX_ANISOTROPY_EXT, sharpness);
    });
    this.texture = new ExternalTexture(this.handle);
  }

  // `picture` has at most the layer's size and comes into its upper left corner; without its smaller copies.
  put(layer: number, level: number, picture: TexImageSource & { width: number; height: number }): void {
    const gl = this.gl;
    this.bound(() => {
      gl.texSubImage3D(gl.TEXTURE_2D_ARRAY, level, 0, 0, layer, picture.width, picture.height, 1, gl.RGBA, gl.UNSIGNED_BYTE, picture);
    });
  }

  // The picture stretched over the whole layer, and its smaller copies: made here, as copies of canvases wait for all that is drawn.
  putWhole(layer: number, picture: ImageBitmap): void {
    const drawing = new OffscreenCanvas(this.width, this.height).getContext("2d", { alpha: false, willReadFrequently: true })!;
    drawing.imageSmoothingQuality = "high";
    drawing.drawImage(picture, 0, 0, this.width, this.height);
    let pixels: Uint8Array = new Uint8Array(drawing.getImageData(0, 0, this.width, this.height).data.buffer);
    this.bound(() => {
      const gl = this.gl;
      for (let level = 0; level < this.levels; level++) {
        const [width, height] = [Math.max(this.width >> level, 1), Math.max(this.height >> level, 1)];
        if (level > 0) pixels = halved(pixels, Math.max(this.width >> (level - 1), 1), Math.max(this.height >> (level - 1), 1));
        gl.texSubImage3D(gl.TEXTURE_2D_ARRAY, level, 0, 0, layer, width, height, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
      }
    });
  }

  makeSmallerCopies(): void {
    this.bound(() => this.gl.generateMipmap(this.gl.TEXTURE_2D_ARRAY));
  }

  private bound(work: () => void): void {
    const gl = this.gl;
    gl.bindTexture(gl.TEXTURE_2D_ARRAY, this.handle);
    gl.pixelStorei(gl.UNPACK_FLIP_Y_WEBGL, false);
    gl.pixelStorei(gl.UNPACK_PREMULTIPLY_ALPHA_WEBGL, false);
    gl.pixelStorei(gl.UNPACK_COLORSPACE_CONVERSION_WEBGL, gl.NONE);
    gl.pixelStorei(gl.UNPACK_ALIGNMENT, 4);
    work();
    gl.bindTexture(gl.TEXTURE_2D_ARRAY, null);
    this.renderer.resetState();
  }
}

// Means of two by two RGBA pixels, of pictures whose sides are powers of two.
export function halved(pixels: Uint8Array, width: number, height: number): Uint8Array {
  const [w, h] = [Math.max(width >> 1, 1), Math.max(height >> 1, 1)];
  const half = new Uint8Array(w * h * 4);
  const right = width > 1 ? 4 : 0;
  const below = height > 1 ? width * 4 : 0;
  for (let y = 0; y < h; y++) {
    for (let x = 0; x < w; x++) {
      const from = (y * 2 * width + x * 2) * 4;
      for (let k = from; k < from + 4; k++) half[(y * w + x) * 4 + k - from] = (pixels[k]! + pixels[k + right]! + pixels[k + below]! + pixels[k + right + below]! + 2) >> 2;
    }
  }
  return half;
}
