"""Vision models that a user has, as ONNX files, behind HTTP: what `python -m marketgen.model_server` serves (docs/models.md).

    sessions   ONNX files: loading, what they take and give, one run at a time
    families   which segmenter two files are; pictures in, logits of masks out
    sampling   logits of the decoder at a picture's own pixels
    masks      masks of everything in a picture, from a grid of points
    regions    small islands and holes of masks
    embedder   vectors of pictures and texts that can be compared
    pictures   PNG and JPEG as arrays
    rle        masks as COCO writes them
    forms      multipart/form-data
    serving    HTTP

Nothing here is imported by `import marketgen`: ONNX Runtime, Pillow and tokenizers are of `pip install "marketgen[models]"`.
"""
